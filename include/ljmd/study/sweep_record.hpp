#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/io/files/open_directory.hpp"
#include "ljmd/study/child_run.hpp"
#include "ljmd/study/sweep_points.hpp"

namespace ljmd {

/// What a sweep was asked for.
struct SweepPlan {
    std::string deck_file;              ///< as the user gave it
    std::string deck;                   ///< the text of it
    std::vector<std::string> settings;  ///< of --set
    SweepPoints points;
};

/// The runs of a sweep in its directory, one a point. All begin from `points/deck.toml`, a copy of the deck, so that
/// nothing depends on what becomes of the deck while they run.
[[nodiscard]] std::vector<ChildRun> sweep_runs(const SweepPlan& plan, const std::filesystem::path& directory);

/// The sweep that a directory holds; nothing when it holds none.
/// @throws DataError  its sweep.json is damaged, or not what `ljmd sweep` writes: the points are such as it takes
[[nodiscard]] std::optional<SweepPlan> recorded_sweep(const std::filesystem::path& directory);

/// Make a directory ready for a sweep: refuse what was not written by this one, or with `force` remove what another
/// sweep has written, runs that both have in common excepted; then write sweep.json and the copy of the deck.
/// What can be known to fail is found before anything is removed. @pre the directory is locked
/// @throws InputError  it holds another sweep, or points of none  @throws DataError  its sweep.json is damaged
/// @throws FileError
void prepare_sweep(const SweepPlan& plan, const OpenDirectory& directory, bool force);

}  // namespace ljmd
