#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/engine/stage.hpp"
#include "ljmd/io/files/open_directory.hpp"

namespace ljmd {

/// When and how a trajectory is written.
struct TrajectoryOutput {
    std::string format;  ///< "h5md", "xyz" or, for few-body systems, "csv"
    Index every;         ///< [steps]
    bool velocities;
    bool accelerations;  ///< csv only
    bool si;
};

/// When checkpoints are written, in addition to those at the start, at the ends of stages, and when a run is stopped.
struct CheckpointOutput {
    Interval every;
    int keep;  ///< generations
};

/// A run as described by its deck: every key consumed, every value in range and in reduced units.
struct Deck {
    DeckKind kind;
    std::string path;                   ///< as the user gave it
    std::string source;                 ///< the text of the file
    std::vector<std::string> settings;  ///< the `--set` arguments that were applied, in order
    std::string title;
    std::optional<SubstanceUnits> units;  ///< from [argon]
    Section root;
    std::vector<Stage> stages;
    std::filesystem::path directory;
    std::optional<OpenDirectory> locked;  ///< the same directory, if a command has locked it; shares the lock
    Index thermo_every;
    std::optional<TrajectoryOutput> trajectory;
    CheckpointOutput checkpoint;

    // Tables of a fluid.
    [[nodiscard]] const Section& system() const { return root.section("system"); }
    [[nodiscard]] const Section& potential() const { return root.section("potential"); }
    [[nodiscard]] const Section& neighbors() const { return root.section("neighbors"); }
    [[nodiscard]] const Section& performance() const { return root.section("performance"); }
    // Tables of a few-body system.
    [[nodiscard]] const Section& force() const { return root.section("force"); }
    [[nodiscard]] const std::vector<Section>& bodies() const { return root.sections("body"); }

    /// The output directory: the locked one, even if its path leads elsewhere by now. @throws FileError
    [[nodiscard]] OpenDirectory outputs() const { return locked ? *locked : OpenDirectory(directory); }
};

/// Read and validate a deck.
/// @param settings  `key=value` of each --set
/// @param force     accept unlikely values (see check_sense)
/// @param diagnostics  receives every error and every warning
/// @return the deck, or nothing when there are errors
[[nodiscard]] std::optional<Deck> load_deck(const std::filesystem::path& path, const std::vector<std::string>& settings,
                                            bool force, Diagnostics& diagnostics);

/// The same for a text in memory. @param name  the deck's name in messages
[[nodiscard]] std::optional<Deck> load_deck_text(const std::string& name, const std::string& text,
                                                 const std::vector<std::string>& settings, bool force,
                                                 Diagnostics& diagnostics);

}  // namespace ljmd
