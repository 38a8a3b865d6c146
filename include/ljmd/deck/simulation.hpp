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

/// What a deck starts from, before atoms are placed: enough to tell N, L and what a run will cost.
struct Start {
    Index atoms;
    Box box;
    std::optional<Configuration> configuration;  ///< when the start is a file
};

/// The file that a deck's `file` means: itself, or in the directory of a run its last configuration.
[[nodiscard]] std::filesystem::path configuration_file(const std::string& file);

/// Work out the start of a deck; reads its file, places nothing.
/// @throws DataError when the file cannot be used
[[nodiscard]] Start find_start(const Deck& deck);

/// Whether a run begins with the velocities of the file that it starts from; else they are drawn.
[[nodiscard]] bool keeps_velocities(const Section& system, const Start& start);

/// Give a state the positions and, where there are any, the velocities of a file. Positions may lie anywhere; edges
/// crossed are counted, so that displacements continue from there.
/// @pre the state has as many atoms, and the file's box
/// @throws DataError for a position far outside the box, or a mass that is not 1
void place_configuration(State& state, const Configuration& configuration);

/// Everything that moves and is moved in a run.
struct Simulation {
    State state;
    PairForceField force_field;
    TailCorrection tail;
    std::optional<TranslationalOrder> order;  ///< when the start is a lattice
    std::vector<std::unique_ptr<Analysis>> analyses;
    Index relaxation_iterations = 0;  ///< of a random start
};

/// Whether a deck of a fluid asks for tail corrections.
[[nodiscard]] bool wants_tail(const Deck& deck);

/// The forces of a deck on a fluid.
[[nodiscard]] PairForceField make_force_field(const Deck& deck);

/// Of a deck of a fluid.
[[nodiscard]] Interaction interaction_of(const Deck& deck);

/// A fluid with nothing in its place yet: what a checkpoint fills.
[[nodiscard]] Simulation empty_simulation(const Deck& deck, Index atoms, const Box& box);

/// The analyses of a deck, nothing sampled yet, for the box that the state has now.
[[nodiscard]] std::vector<std::unique_ptr<Analysis>> make_analyses(const Deck& deck, const Simulation& simulation);

/// Place the atoms, draw or take velocities, and set up forces and analyses.
/// @param warn  receives one line for each thing a user should know
/// @pre the deck has been checked against the start's box
[[nodiscard]] Simulation make_simulation(const Deck& deck, Start start,
                                         const std::function<void(const std::string&)>& warn);

}  // namespace ljmd
