#include "ljmd/study/point_run.hpp"

#include <fmt/format.h>

#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/run/recorded_results.hpp"

namespace ljmd {

PointRun::PointRun(ChildRun run, std::vector<std::string> values)
    : run_(std::move(run)), point_{run_.name, std::move(values), run_.directory, {}, "", {}} {}

std::optional<Job> PointRun::begin() {
    try {
        auto job = next_job(run_);
        if (!job) {
            take_results();
        }
        return job;
    } catch (const DataError& error) {  // a damaged run.json
        point_.failure = fmt::format("{}: {}", run_.name, error.what());
        return std::nullopt;
    }
}

std::optional<Job> PointRun::after(int exit_status) {
    if (exit_status == 0) {
        take_results();
    } else {
        point_.failure = failure_of(run_, exit_status);
    }
    return std::nullopt;
}

void PointRun::take_results() {
    try {
        RecordedResults results = read_results(run_.directory / "results.json");
        point_.found = std::move(results.means);
        point_.doubts = std::move(results.doubts);
    } catch (const DataError& error) {
        point_.failure = fmt::format("{}: {}", run_.name, error.what());
    }
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
