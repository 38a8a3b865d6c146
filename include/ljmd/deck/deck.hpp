#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/deck/given_parts.hpp"
#include "ljmd/deck/tables/few_body_tables.hpp"
#include "ljmd/deck/tables/fluid_tables.hpp"
#include "ljmd/engine/stage.hpp"
#include "ljmd/io/files/open_directory.hpp"
#include "ljmd/options/diagnostics.hpp"

namespace ljmd {

/// A run as described by its deck: every key consumed, every value in range and in reduced units.
struct Deck {
    std::string path;                   ///< as the user gave it
    std::string source;                 ///< the text of the file
    std::vector<std::string> settings;  ///< the `--set` arguments that were applied, in order
    std::string title;
    std::optional<SubstanceUnits> units;  ///< from [argon]
    std::variant<Placed<FluidTables>, Placed<FewBodyTables>> tables;
    std::vector<Stage> stages;
    std::filesystem::path directory;
    std::optional<OpenDirectory> locked = {};  ///< the same directory, if a command has locked it; shares the lock
    Index thermo_every;
    std::optional<TrajectoryOutput> trajectory;
    CheckpointOutput checkpoint;
    bool report = false;         ///< whether `ljmd run` ends with a page about the run
    bool start_at_hand = false;  ///< nothing is read: the run writes the configuration that it starts from
    GivenParts given = {};       ///< what a program gives to the run beside this

    [[nodiscard]] DeckKind kind() const {
        return std::holds_alternative<Placed<FluidTables>>(tables) ? DeckKind::fluid : DeckKind::few_body;
    }

    // The tables of a deck of that kind.
    [[nodiscard]] const Placed<FluidTables>& fluid() const { return std::get<Placed<FluidTables>>(tables); }
    [[nodiscard]] const Placed<FewBodyTables>& few_body() const { return std::get<Placed<FewBodyTables>>(tables); }

    // Tables of a fluid.
    [[nodiscard]] const Placed<SystemTable>& system() const { return fluid().system; }
    [[nodiscard]] const Placed<PotentialTable>& potential() const { return fluid().potential; }
    [[nodiscard]] const Placed<NeighborSpec>& neighbors() const { return fluid().neighbors; }

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
/// @param given  what a program gives to the run beside the deck
[[nodiscard]] std::optional<Deck> load_deck_text(const std::string& name, const std::string& text,
                                                 const std::vector<std::string>& settings, bool force,
                                                 Diagnostics& diagnostics, GivenParts given = {});

}  // namespace ljmd
