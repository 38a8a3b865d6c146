#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/analyze/trajectory_analyses.hpp"

namespace ljmd {

/// A trajectory that is to be analyzed.
struct AnalyzedTrajectory {
    std::filesystem::path path;
    const Deck* deck = nullptr;  ///< null: none is known
    TrajectorySummary summary;
    FrameSelection selection;
    std::string group = {};     ///< of particles, see open_trajectory()
    bool thermo = false;        ///< energies and pressures of the frames are wanted, see check_thermo()
    std::string xyz_comment{};  ///< what the comment lines of an extended XYZ file lack

    [[nodiscard]] std::optional<SubstanceUnits> units() const { return deck != nullptr ? deck->units : std::nullopt; }
};

/// What was found in a trajectory.
struct TrajectoryResult {
    std::vector<ObservableAverage> averages;
    std::vector<DataTable> tables;
    std::vector<std::string> warnings;
    bool used_displacements = false;  ///< so that it matters whether positions are wrapped
};

/// Feed the analyses with the frames that are selected. Wrapped positions are unwrapped by the nearest image from frame
/// to frame. Forces are evaluated where one needs them, and for `thermo`, which gives the
/// averages that a run has of its rows. Of a trajectory with velocities there is the temperature in any case.
/// @throws DataError  the file is not what it was when it was summarized, a mass is not 1, or atoms overlap so that
/// their forces are not finite
[[nodiscard]] TrajectoryResult analyze_trajectory(const AnalyzedTrajectory& trajectory,
                                                  const std::vector<FrameAnalysis>& analyses);

/// For people: what was analyzed, and one line an observable.
[[nodiscard]] std::string trajectory_table(const AnalyzedTrajectory& trajectory, const TrajectoryResult& result);

/// trajectory, atoms, box_edges, frames, frames_used, spacing, positions; observables as in results.json; warnings.
[[nodiscard]] std::string trajectory_json(const AnalyzedTrajectory& trajectory, const TrajectoryResult& result);

}  // namespace ljmd
