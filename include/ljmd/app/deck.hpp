#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/section.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// One [[stage]] of a deck.
struct Stage {
    std::string name;
    std::string integrator;
    double time_step;  ///< [tau]
    Index steps;
    double temperature;  ///< what a thermostat holds [epsilon/k_B]
    bool sample;         ///< observables are measured
    Section section;     ///< for the thermostat's own keys
};

/// When and how a trajectory is written.
struct TrajectoryOutput {
    std::string format;  ///< "h5md" or "xyz"
    Index every;         ///< [steps]
    bool velocities;
    bool si;
};

/// A run as its deck describes it: every key consumed, every value in range and in reduced units.
struct Deck {
    std::string path;                   ///< as the user gave it
    std::string source;                 ///< the text of the file
    std::vector<std::string> settings;  ///< the `--set` that were applied, in order
    std::string title;
    std::optional<SubstanceUnits> units;  ///< of [argon]
    Section root;
    std::vector<Stage> stages;
    std::filesystem::path directory;
    Index thermo_every;
    std::optional<TrajectoryOutput> trajectory;

    [[nodiscard]] const Section& system() const { return root.section("system"); }
    [[nodiscard]] const Section& potential() const { return root.section("potential"); }
    [[nodiscard]] const Section& neighbors() const { return root.section("neighbors"); }
    [[nodiscard]] Index total_steps() const;
};

/// The keys of a deck: what validates it, and what the reference page is made from.
[[nodiscard]] Schema deck_schema();

/// The reference page of all deck keys, in Markdown.
[[nodiscard]] std::string deck_reference_page();

/// Read and validate a deck.
/// @param settings  `key=value` of each --set
/// @param force     accept what is refused as unlikely (see check_sense)
/// @param diagnostics  receives every mistake and every warning
/// @return the deck, or nothing when there are errors
[[nodiscard]] std::optional<Deck> load_deck(const std::filesystem::path& path, const std::vector<std::string>& settings,
                                            bool force, Diagnostics& diagnostics);

}  // namespace ljmd
