#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/deck_schema.hpp"
#include "deck/run_plan.hpp"
#include "deck/tables/few_body_tables.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// A run as described by its deck: every key consumed, every value in range and in reduced units. What is run stands in
/// the values of the plan; its tables are for who looks for places in the text.
struct Deck : RunPlan {
    std::variant<Placed<FluidTables>, Placed<FewBodyTables>> tables;

    // The tables of a deck that has them.
    [[nodiscard]] const Placed<FluidTables>& fluid() const { return std::get<Placed<FluidTables>>(tables); }
    [[nodiscard]] const Placed<FewBodyTables>& few_body() const { return std::get<Placed<FewBodyTables>>(tables); }
    [[nodiscard]] const Placed<SystemTable>& system() const { return fluid().system; }
    [[nodiscard]] const Placed<PotentialTable>& potential() const { return fluid().potential; }
    [[nodiscard]] const Placed<NeighborSpec>& neighbors() const { return fluid().neighbors; }
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
