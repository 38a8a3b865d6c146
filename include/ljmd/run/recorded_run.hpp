#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/run/run_record.hpp"

namespace ljmd {

/// The deck that a run was made with, as its run.json has it.
/// @param directory    of the run
/// @param settings     `key=value` of each --set, applied after those of the run; none of [system], which tells how the
///                     run began
/// @param diagnostics  receives every mistake that they make; what is merely unlikely is no error, as the run took it
/// @throws DataError   there is no run.json, or it is not ljmd's
/// @throws InputError  a mistake in the settings
[[nodiscard]] Deck recorded_deck(const std::filesystem::path& directory, const std::vector<std::string>& settings,
                                 Diagnostics& diagnostics);

/// A run as its directory shows it, to be gone on with.
struct RecordedRun {
    Deck deck;             ///< writes to the directory
    EarlierParts earlier;  ///< without the part that begins now
    std::string simd;      ///< level that it was computed with; empty for a few bodies
    int threads;
    bool finished;
};

/// @param more_steps  at the end of the last stage, beside those that were added earlier
/// @throws DataError as recorded_deck  @throws InputError more steps than can be counted
[[nodiscard]] RecordedRun recorded_run(const std::filesystem::path& directory, Index more_steps = 0);

/// The last configuration of a fluid's run, as its final.xyz has it.
/// @throws DataError  there is none, or it cannot be used
[[nodiscard]] State last_configuration(const std::filesystem::path& directory, const Deck& deck);

}  // namespace ljmd
