#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/observables/statistics/wanted_errors.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "ljmd/reference/fluid_phase.hpp"
#include "reference/canonical_size.hpp"
#include "study/reference/reference_property.hpp"

namespace ljmd {

/// What `ljmd reference` is asked for.
struct ReferenceRequest {
    double temperature = 0.0;
    std::optional<double> density{};  ///< [sigma^-3]; either this or a pressure is given
    std::optional<double> pressure{};
    std::vector<std::string> properties{};  ///< names of reference_properties()
    std::vector<WantedError> errors{};      ///< of some of them
    Index atoms = 0;                        ///< 0: as many as the state needs
    Index replicas = 4;
    Index max_steps = 2'000'000;  ///< of a replica, in each kind of run
    std::uint64_t seed = 1;
    bool metastable = false;  ///< whether a state that is not the stable one is accepted

    /// Whether a property is asked for that is measured in this way.
    [[nodiscard]] bool needs(MeasuredBy measured) const;
};

/// How the runs of a request are made.
struct ReferenceSetup {
    ReferenceRequest request;
    double density;
    PhaseOfState phase;
    FluidProperties expected;  ///< by thol2016
    Index cells;               ///< of the fcc lattice, along an edge
    Index atoms;
    PairPotential potential;  ///< Lennard-Jones, switched off within 0.5 sigma before the cutoff
    double time_step;         ///< [tau]
    double temperature_of_melt;
    SizeShift size;           ///< shift of so many atoms, by thol2016
    SizeShift size_by_other;  ///< the same by kolafa-nezbeda1994
    std::vector<std::string> remarks;

    [[nodiscard]] double edge() const;
    /// Radius up to which pairs are counted for the correction of the cutoff [sigma].
    [[nodiscard]] double counted_radius() const;
};

/// Largest S(0) of a state that is accepted: nearer to the critical point a box of a few thousand atoms is too small
/// for its correlations.
inline constexpr double max_structure_factor_at_zero = 8.0;

/// Choose the runs for a request.
///
/// The potential is Lennard-Jones, switched off from 3.5 to 4 sigma (less in a box that is too small) with tail
/// corrections, for 864 atoms; where the fluid is compressible up to 4000 atoms and 7 sigma. Time step 0.005 tau,
/// shorter above T = 2. If no errors are asked for, 0.1 % of the energy, and 1 % of rho T for the pressure.
/// @throws InputError    no density or pressure, or both; a value out of its range; errors of properties that are not
/// asked for; fewer than 108 atoms or not 4 n^3 of them, or too few for a cutoff of 2.5
/// @throws PhysicsError  the state is refused: outside the range of the equation of state, two phases, a solid, too
/// near the critical point, or metastable without permission
[[nodiscard]] ReferenceSetup reference_setup(const ReferenceRequest& request);

/// The deck of a short run that finds when the fluid is in equilibrium.
[[nodiscard]] std::string pilot_deck(const ReferenceSetup& setup);

/// The deck of a canonical run: the Langevin thermostat BAOAB, whose configurations are accurate to a high order of the
/// time step. @param equilibration  steps before sampling
[[nodiscard]] std::string canonical_deck(const ReferenceSetup& setup, Index equilibration);

/// The deck of a run at constant energy, for transport. @param total_energy  per atom, the canonical runs'
[[nodiscard]] std::string transport_deck(const ReferenceSetup& setup, Index equilibration, double total_energy);

/// Length of the sampled stage in the deck of a canonical or a transport run [steps]. Later rounds add steps until the
/// errors are reached.
[[nodiscard]] Index first_steps(const ReferenceSetup& setup, bool transport);

/// Time step of runs at constant energy, which have no thermostat to correct their velocities [tau].
[[nodiscard]] double transport_time_step(const ReferenceSetup& setup);

inline constexpr Index pilot_steps = 4000;
inline constexpr Index rows_every = 10;  ///< steps between rows of thermo.csv

}  // namespace ljmd
