#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/thermodynamics.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Watches a stage for the signs of a time step that is too large. An explosion shows in the speed of single atoms;
/// slow heating does not, and NaN checks see neither.
class StabilityWatch {
  public:
    /// @param time_step        [tau]
    /// @param constant_energy  the stage has no thermostat: its total energy is conserved
    StabilityWatch(double time_step, bool constant_energy, const PairPotential& potential);

    /// @throws PhysicsError when an atom moves half a sigma or more in one step, naming the fastest atom
    void check_speeds(const State& state) const;

    /// Compare the total energy with that of the first call. It may rise by a tenth of an epsilon and a tenth of the
    /// kinetic energy, and by what a plain cut adds when a few pairs of each atom cross it: sound runs stay far below.
    /// @throws PhysicsError when it has risen more, in a stage at constant energy
    void check_energy(const Thermodynamics& now);

    void archive(Archive& a) { a(at_first_); }

  private:
    double time_step_;
    bool constant_energy_;
    double jump_at_cutoff_;           ///< |u(rc)| [epsilon]
    std::optional<double> at_first_;  ///< total energy per atom [epsilon]
};

}  // namespace ljmd
