#pragma once

#include <optional>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Watches a stage for signs of a time step that is too large. Speeds of single atoms reveal an explosion, the total
/// energy reveals slow heating. Checks for NaN would find neither.
class StabilityWatch {
  public:
    /// @param time_step        [tau]
    /// @param constant_energy  the stage has no thermostat, so its total energy is conserved
    StabilityWatch(double time_step, bool constant_energy, const PairPotential& potential);

    /// @throws PhysicsError naming the fastest atom, if it moves half a sigma or more in one step
    void check_speeds(const State& state) const;

    /// Compare the total energy with the first call's. It may rise by a tenth of an epsilon and a tenth of the
    /// kinetic energy per atom, and by what a plain cut adds when a few pairs of each atom cross it. Sound runs stay
    /// far below that.
    /// @throws PhysicsError if it has risen more, in a stage at constant energy
    void check_energy(const Thermodynamics& now);

    void archive(Archive& a) { a(at_first_); }

  private:
    double time_step_;
    bool constant_energy_;
    double jump_at_cutoff_;           ///< |u(rc)| [epsilon]
    std::optional<double> at_first_;  ///< total energy per atom at the first call [epsilon]
};

}  // namespace ljmd
