#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "deck/deck.hpp"
#include "engine/fluid_system.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/model/configuration.hpp"

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
[[nodiscard]] bool keeps_velocities(const SystemTable& system, const Start& start);

/// sampled_run() of a deck.
[[nodiscard]] SampledRun sampled_run(const Deck& deck, Index atoms, const Box& box);

/// What the tables of a fluid say. Of a start file nothing is read: the configuration is empty.
/// @pre they make sense, see check_sense()
[[nodiscard]] FluidSpec spec_of(const FluidTables& tables, const std::optional<SubstanceUnits>& units);

/// fluid_spec() of a deck, with the configuration of its start.
/// @throws DataError when velocities are to be taken from a file that has none, or to be drawn without a temperature
[[nodiscard]] FluidSpec fluid_spec(const Deck& deck, Start start);

}  // namespace ljmd
