#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "ljmd/detail/model/state.hpp"
#include "run/continuation.hpp"

namespace ljmd {

inline constexpr std::size_t max_settings = 10'000;  ///< --set arguments in a record

/// The message about a directory without run.json: what else of ljmd it holds, and which command takes that.
[[nodiscard]] std::string not_a_run(const std::filesystem::path& directory);

/// The deck of a run, from its run.json.
/// @param directory    of the run
/// @param settings     `key=value` of each --set, applied after the run's own; none of [system], which describes the
/// start of the run
/// @param diagnostics  receives the mistakes in them; unlikely values are only warnings, because the run accepted them
/// @throws DataError   there is no run.json, or it is not ljmd's
/// @throws InputError  a mistake in the settings
[[nodiscard]] Deck recorded_deck(const std::filesystem::path& directory, const std::vector<std::string>& settings,
                                 Diagnostics& diagnostics);

/// A run as recorded in its directory, to be resumed.
struct RecordedRun {
    Deck deck;             ///< its output directory is the run's
    EarlierParts earlier;  ///< without the part that begins now
    std::string simd;      ///< level that the run was computed with; empty for a few-body run
    int threads;
    bool finished;
};

/// @param more_steps  added to the last stage, besides those added earlier
/// @throws DataError as recorded_deck()  @throws InputError more steps than can be counted
[[nodiscard]] RecordedRun recorded_run(const std::filesystem::path& directory, Index more_steps = 0);

/// Add steps to a run whose last stage was ended by `until`: to those that it took, not to its max_steps, and its
/// errors end it no more.
/// @param more_steps  as given to recorded_run()
void continue_past_errors(RecordedRun& run, Continuation& continuation, Index more_steps);

/// Steps of a run with this checkpoint: at most the steps of its stages, and exactly those that were taken where
/// `until` has ended it.
[[nodiscard]] Index steps_of_run(const RecordedRun& run, const CheckpointHead& head);

/// The last configuration of a fluid's run, from its final.xyz.
/// @throws DataError  there is none, or it cannot be used
[[nodiscard]] State last_configuration(const std::filesystem::path& directory, const Deck& deck);

}  // namespace ljmd
