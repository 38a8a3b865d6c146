#include "study/point_run.hpp"

#include <utility>

#include "run/recorded_results.hpp"

namespace ljmd {

PointRun::PointRun(ChildRun run, std::vector<std::string> values)
    : run_(std::move(run)), point_{run_.name, std::move(values), run_.directory, {}, "", {}} {}

std::optional<Job> PointRun::first_job() {
    auto job = ljmd::next_job(run_);
    return job ? job : next_job();
}

std::optional<Job> PointRun::next_job() {
    RecordedResults results = read_results(run_.directory / "results.json");
    point_.found = std::move(results.means);
    point_.doubts = std::move(results.doubts);
    return std::nullopt;
}

SweptPoint PointRun::point() const {
    SweptPoint point = point_;
    point.failure = failure();
    return point;
}

std::vector<PointRun> point_runs(const SweepPlan& plan, const std::filesystem::path& directory) {
    std::vector<PointRun> runs;
    runs.reserve(plan.points.values.size());
    for (ChildRun& run : sweep_runs(plan, directory)) {
        runs.emplace_back(std::move(run), plan.points.values[runs.size()]);
    }
    return runs;
}

}  // namespace ljmd
