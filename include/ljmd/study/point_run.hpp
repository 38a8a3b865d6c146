#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/study/run_lines.hpp"
#include "ljmd/study/sweep_record.hpp"
#include "ljmd/study/sweep_report.hpp"

namespace ljmd {

/// A point of a sweep being computed, by one run.
class PointRun : public RunLine {
  public:
    PointRun(ChildRun run, std::vector<std::string> values);

    [[nodiscard]] const ChildRun& run() const override { return run_; }
    [[nodiscard]] std::optional<Job> begin() override;
    [[nodiscard]] std::optional<Job> after(int exit_status) override;
    [[nodiscard]] const std::string& failure() const override { return point_.failure; }
    void set_failure(std::string why) override { point_.failure = std::move(why); }

    /// What is known: its results when it is at its end.
    [[nodiscard]] const SweptPoint& point() const { return point_; }

  private:
    void take_results();

    ChildRun run_;
    SweptPoint point_;
};

/// The points of a sweep in a directory.
[[nodiscard]] std::vector<PointRun> point_runs(const SweepPlan& plan, const std::filesystem::path& directory);

}  // namespace ljmd
