#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyze/trajectory_analyses.hpp"
#include "core/document.hpp"
#include "ljmd/analyze/trajectory.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A trajectory to be analysed.
struct AnalyzedTrajectory {
    std::filesystem::path path;
    const Deck* deck = nullptr;  ///< null: unknown
    TrajectorySummary summary;
    FrameSelection selection;
    std::string group = {};     ///< particle group, see open_trajectory()
    bool thermo = false;        ///< compute energies and pressures of the frames, see check_thermo()
    std::string xyz_comment{};  ///< keys missing from the comment lines of an extended XYZ file
    Execution execution{};      ///< for the states of the frames

    [[nodiscard]] std::optional<SubstanceUnits> units() const { return deck != nullptr ? deck->units() : std::nullopt; }
};

/// What a trajectory is told where its file leaves it open, and which frames are measured.
struct FrameOptions {
    std::optional<double> from = {};          ///< frames before this time are left out [tau]
    std::optional<double> time_step = {};     ///< see select_frames(); none: the deck's, for files with steps
    std::string group = {};                   ///< see open_trajectory()
    std::optional<Positions> positions = {};  ///< none: found from the file or the displacements
    std::string xyz_comment = {};
};

/// Read a trajectory once, and select its frames.
/// @param deck    null: unknown; it outlives the result
/// @param is_run  the deck is from the run that wrote the trajectory
/// @param thermo  compute energies and pressures of the frames, see check_thermo()
/// @throws InputError, DataError as summarize(), select_frames() and check_thermo()
[[nodiscard]] AnalyzedTrajectory trajectory_to_analyze(const std::filesystem::path& path, const Deck* deck, bool is_run,
                                                       bool thermo, const FrameOptions& options,
                                                       const FrameRead& frame_read = {});

/// Read all frames of a trajectory again. @param take  receives the number of each, from 0
/// @throws DataError  the file has changed since it was summarised
void each_frame(const AnalyzedTrajectory& trajectory,
                const std::function<void(std::size_t number, Configuration&& frame)>& take,
                const FrameRead& frame_read = {});

/// Feed the selected frames to the analyses. Wrapped positions are unwrapped frame by frame with nearest images. Forces
/// are evaluated if an analysis needs them, and for `thermo`, which gives the same averages as the rows of a run. The
/// temperature is given for every trajectory with velocities.
/// @throws DataError  the file has changed since it was summarised, a mass is not 1, or atoms overlap so that their
/// forces are not finite
[[nodiscard]] TrajectoryResult analyze_trajectory(const AnalyzedTrajectory& trajectory,
                                                  const std::vector<FrameAnalysis>& analyses,
                                                  const FrameRead& frame_read = {});

/// The result as a document. Text: the trajectory, and one line per observable. Data: trajectory, atoms, box_edges,
/// frames, frames_used, spacing, positions; observables as in results.json; warnings.
[[nodiscard]] Document trajectory_document(const AnalyzedTrajectory& trajectory, const TrajectoryResult& result);

}  // namespace ljmd
