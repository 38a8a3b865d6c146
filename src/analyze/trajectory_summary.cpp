#include "analyze/trajectory_summary.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Edges may be stored in single precision. They count as equal within this relative difference.
constexpr double same_edge = 1e-6;

/// @param ids  ascending; empty if the file has none
bool tells_of_others(const std::vector<Index>& ids) {
    return !ids.empty() && (ids.front() > 1 || ids.back() - ids.front() + 1 != std::ssize(ids));
}

/// Collects the properties of the frames.
class Summarizer {
  public:
    void add(const Frame& frame) {
        const Configuration& found = frame.configuration;
        if (summary_.frames == 0) {
            summary_.atoms = std::ssize(found.positions);
            summary_.is_part = tells_of_others(frame.ids);
            summary_.edges = found.edges;
            summary_.smallest_edges = found.edges;
            summary_.has_velocities = true;
        }
        if (frame.begins_anew) {
            summary_.breaks.push_back(static_cast<std::size_t>(summary_.frames));
            meter_.begin_anew();
        }
        ++summary_.frames;
        if (!found.velocities.empty()) {
            any_velocities_ = true;
        } else if (summary_.has_velocities) {
            summary_.has_velocities = false;
            first_without_ = summary_.frames;
        }
        const Vec3 change = (found.edges - summary_.edges).cwiseAbs();
        if (!summary_.box_changes && (change.array() > same_edge * summary_.edges.array()).any()) {
            summary_.box_changes = summary_.frames;
        }
        summary_.smallest_edges = summary_.smallest_edges.cwiseMin(found.edges);
        if (found.step) {
            summary_.steps.push_back(*found.step);
        }
        if (found.time) {
            summary_.times.push_back(*found.time);
        }
        tells_unwrapped_ = tells_unwrapped_ && found.is_unwrapped;
        meter_.add(found);
    }

    /// @param unused  TrajectoryReader::unused_velocities()
    [[nodiscard]] TrajectorySummary finish(std::optional<Positions> said, const std::string& unused) {
        if (!summary_.has_velocities) {
            summary_.missing_velocities = any_velocities_  ? fmt::format("which frame {} does not have", first_without_)
                                          : unused.empty() ? "which the trajectory does not have"
                                                           : fmt::format("which the trajectory has {}", unused);
        }
        summary_.motion = meter_.motion();
        summary_.positions = read_positions(summary_.motion, tells_unwrapped_, said);
        return std::move(summary_);
    }

  private:
    TrajectorySummary summary_{};
    bool any_velocities_ = false;
    Index first_without_ = 0;  ///< number of the first frame without velocities
    bool tells_unwrapped_ = true;
    FrameMotionMeter meter_;
};

}  // namespace

TrajectorySummary summarize(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                            const std::string& group, std::optional<Positions> positions,
                            const std::string& xyz_comment, const FrameRead& frame_read) {
    const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path, units, group, xyz_comment);
    Summarizer summarizer;
    Frame frame;
    while (reader->next(frame)) {
        summarizer.add(frame);
        if (frame_read) {
            frame_read();
        }
    }
    if (reader->frames() == 0) {
        throw DataError(fmt::format("{}: the file has no frame", path.string()));
    }
    TrajectorySummary summary = summarizer.finish(positions, reader->unused_velocities());
    summary.warnings = reader->warnings();
    return summary;
}

}  // namespace ljmd
