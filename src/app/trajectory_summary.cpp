#include "ljmd/app/trajectory_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Edges are stored with the digits of a single-precision number, or more; they count as the same within this.
constexpr double same_edge = 1e-6;
constexpr double late_wrapping = 1.05;

/// Gathers what frames tell, one after the other.
class Summarizer {
  public:
    void add(const Frame& frame) {
        const Configuration& found = frame.configuration;
        if (summary_.frames == 0) {
            summary_.atoms = std::ssize(found.positions);
            summary_.edges = found.edges;
            summary_.smallest_edges = found.edges;
            summary_.has_velocities = !found.velocities.empty();
        }
        ++summary_.frames;
        const Vec3 change = (found.edges - summary_.edges).cwiseAbs();
        if (!summary_.box_changes && (change.array() > same_edge * summary_.edges.array()).any()) {
            summary_.box_changes = summary_.frames;
        }
        summary_.smallest_edges = summary_.smallest_edges.cwiseMin(found.edges);
        if (frame.has_step) {
            summary_.steps.push_back(found.step);
        }
        if (frame.has_time) {
            summary_.times.push_back(found.time);
        }
        unwrapped_ = unwrapped_ && frame.wrapping == Wrapping::unwrapped;
        told_ = told_ && frame.wrapping != Wrapping::not_told;
        for (const Vec3& r : found.positions) {
            const Vec3 in_edges = r.cwiseQuotient(found.edges);
            lowest_ = lowest_.cwiseMin(in_edges);
            highest_ = highest_.cwiseMax(in_edges);
        }
    }

    [[nodiscard]] TrajectorySummary finish() {
        const auto has_all = [&](const auto& of_frames) { return std::ssize(of_frames) == summary_.frames; };
        if (!has_all(summary_.steps)) {
            summary_.steps.clear();
        }
        if (!has_all(summary_.times)) {
            summary_.times.clear();
        }
        const bool spread = (highest_ - lowest_).maxCoeff() > late_wrapping;
        summary_.wrapped = told_ ? !unwrapped_ : !spread;
        return std::move(summary_);
    }

  private:
    TrajectorySummary summary_{};
    bool unwrapped_ = true;
    bool told_ = true;
    Vec3 lowest_ = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< of all positions, in edges
    Vec3 highest_ = -lowest_;
};

}  // namespace

TrajectorySummary summarize(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units) {
    const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path, units);
    Summarizer summarizer;
    Frame frame;
    while (reader->next(frame)) {
        summarizer.add(frame);
    }
    if (reader->frames() == 0) {
        throw DataError(fmt::format("{}: the file has no frame", path.string()));
    }
    TrajectorySummary summary = summarizer.finish();
    summary.warning = reader->warning();
    return summary;
}

}  // namespace ljmd
