#pragma once

#include <string>
#include <utility>
#include <vector>

#include "study/run_lines.hpp"
#include "study/sweep_record.hpp"
#include "study/sweep_report.hpp"

namespace ljmd {

/// A point of a sweep being computed, by one run.
class PointRun : public RunLine {
  public:
    PointRun(ChildRun run, std::vector<std::string> values);

    [[nodiscard]] const ChildRun& run() const override { return run_; }

    /// What is known: its results when it is at its end.
    [[nodiscard]] SweptPoint point() const;

  private:
    [[nodiscard]] std::optional<Job> first_job() override;
    [[nodiscard]] std::optional<Job> next_job() override;

    ChildRun run_;
    SweptPoint point_;
};

/// The points of a sweep in a directory.
[[nodiscard]] std::vector<PointRun> point_runs(const SweepPlan& plan, const std::filesystem::path& directory);

}  // namespace ljmd
