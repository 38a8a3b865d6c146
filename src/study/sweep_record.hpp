#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/files/open_directory.hpp"
#include "study/child_run.hpp"
#include "study/sweep_points.hpp"

namespace ljmd {

/// The request of a sweep.
struct SweepPlan {
    std::string deck_file;              ///< as the user gave it
    std::string deck;                   ///< text of the deck
    std::vector<std::string> settings;  ///< arguments of --set
    SweepPoints points;
    Index replicas = 0;     ///< above 0: the points are that many replicas of one deck, see replica_plan()
    Index steps_added = 0;  ///< to the last stage of each replica
};

/// The runs of a sweep in its directory, one per point. All use `points/deck.toml`, a copy of the deck, so that later
/// changes of the deck have no effect.
[[nodiscard]] std::vector<ChildRun> sweep_runs(const SweepPlan& plan, const std::filesystem::path& directory);

/// The sweep in a directory; nothing if there is none.
/// @throws DataError  its sweep.json is damaged, or `ljmd sweep` cannot have written it, for example because of its
/// points
[[nodiscard]] std::optional<SweepPlan> recorded_sweep(const std::filesystem::path& directory);

/// Prepare a directory for a sweep: refuse files of another sweep, or with `force` remove them, except for runs that
/// both sweeps have in common; then write sweep.json and the copy of the deck. Foreseeable failures are found before
/// anything is removed, and before there is any waiting. @pre the directory is locked
/// @param wait  called before runs of another sweep are removed, and before replicas' runs are resumed: returns when
/// none of them writes any more
/// @throws InputError  it holds another sweep, or points without a sweep  @throws DataError  its sweep.json is damaged
/// @throws InUseError  workers run the points of the other sweep  @throws FileError
void prepare_sweep(
    const SweepPlan& plan, const OpenDirectory& directory, bool force,
    const std::function<void(const std::filesystem::path& points)>& wait = [](const std::filesystem::path&) {});

/// Write sweep.json anew, for the same runs. @pre the directory holds this sweep, and is locked  @throws FileError
void record_sweep(const SweepPlan& plan, const OpenDirectory& directory);

}  // namespace ljmd
