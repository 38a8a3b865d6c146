#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "forces/pair_force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/execution/execution.hpp"
#include "observables/structure/order_parameter.hpp"

namespace ljmd {

/// The atoms, forces and analyses of a run of a fluid.
struct FluidSystem {
    State state;
    PairForceField force_field;
    TailCorrection tail;
    std::optional<TranslationalOrder> order;  ///< when the start is a lattice
    std::vector<std::unique_ptr<Analysis>> analyses;
    Index relaxation_iterations = 0;  ///< of a random start
};

/// The force field of a fluid.
[[nodiscard]] PairForceField make_force_field(const FluidSpec& spec, const Execution& execution);

/// The analyses of a fluid, without samples, for the present box of the state.
/// @pre mistakes() finds none
[[nodiscard]] std::vector<std::unique_ptr<Analysis>> make_analyses(const FluidSpec& spec, const State& state);

/// A fluid whose atoms are not placed yet: filled in from a checkpoint.
/// @param execution  computes all of it
[[nodiscard]] FluidSystem empty_fluid(const FluidSpec& spec, Index atoms, const Box& box, const Execution& execution);

/// Set the positions and, if there are any, the velocities of a state from a configuration. Positions outside the box
/// are wrapped and the crossed edges counted, so that displacements continue from there.
/// @pre the state has the same number of atoms and the configuration's box
/// @throws DataError for a position far outside the box, or a mass that is not 1
void place_configuration(State& state, const Configuration& configuration);

/// Place the atoms, set velocities, and create forces and analyses. The centre of mass is at rest; under an external
/// force it moves as in the configuration, if velocities are kept.
/// @param execution  computes all of it
/// @param warn       receives one line per remark for the user
/// @pre mistakes() finds none  @throws DataError as place_configuration, PhysicsError as relax
[[nodiscard]] FluidSystem make_fluid(const FluidSpec& spec, const Execution& execution,
                                     const std::function<void(const std::string&)>& warn);

}  // namespace ljmd
