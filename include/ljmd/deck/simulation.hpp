#pragma once

#include <memory>
#include <optional>

#include "ljmd/deck/deck.hpp"
#include "ljmd/forces/pair_force_field.hpp"
#include "ljmd/model/configuration.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/structure/order_parameter.hpp"
#include "ljmd/potentials/tail_correction.hpp"

namespace ljmd {

/// The start of a deck before atoms are placed: enough to know N, L and the cost of the run.
struct Start {
    Index atoms;
    Box box;
    std::optional<Configuration> configuration;  ///< if the start is a file
};

/// The file that a deck's `file` refers to: itself, or the last configuration if it is the directory of a run.
[[nodiscard]] std::filesystem::path configuration_file(const std::string& file);

/// Determine the start of a deck: reads its file, places no atoms.
/// @throws DataError when the file cannot be used
[[nodiscard]] Start find_start(const Deck& deck);

/// Whether a run keeps the velocities of its start file; else they are drawn.
[[nodiscard]] bool keeps_velocities(const Section& system, const Start& start);

/// Set the positions and, if there are any, the velocities of a state from a file. Positions outside the box are
/// wrapped and the crossed edges counted, so that displacements continue from there.
/// @pre the state has the same number of atoms and the file's box
/// @throws DataError for a position far outside the box, or a mass that is not 1
void place_configuration(State& state, const Configuration& configuration);

/// The atoms, forces and analyses of a run.
struct Simulation {
    State state;
    PairForceField force_field;
    TailCorrection tail;
    std::optional<TranslationalOrder> order;  ///< when the start is a lattice
    std::vector<std::unique_ptr<Analysis>> analyses;
    Index relaxation_iterations = 0;  ///< of a random start
};

/// Whether a fluid's deck asks for tail corrections.
[[nodiscard]] bool wants_tail(const Deck& deck);

/// The force field of a fluid's deck. @param execution  see PairForceField
[[nodiscard]] PairForceField make_force_field(const Deck& deck, const Execution& execution);

/// The interaction of a fluid's deck.
[[nodiscard]] Interaction interaction_of(const Deck& deck);

/// A fluid whose atoms are not placed yet: filled in from a checkpoint.
/// @param execution  computes all of it, see execution_options()
[[nodiscard]] Simulation empty_simulation(const Deck& deck, Index atoms, const Box& box, const Execution& execution);

/// The analyses of a deck, without samples, for the current box of the state.
[[nodiscard]] std::vector<std::unique_ptr<Analysis>> make_analyses(const Deck& deck, const Simulation& simulation);

/// Place the atoms, set velocities, and create forces and analyses.
/// @param execution  computes all of it, see execution_options()
/// @param warn       receives one line per remark for the user
/// @pre the deck was checked against the box of the start
[[nodiscard]] Simulation make_simulation(const Deck& deck, Start start, const Execution& execution,
                                         const std::function<void(const std::string&)>& warn);

}  // namespace ljmd
