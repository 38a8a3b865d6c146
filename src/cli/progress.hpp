#pragma once

#include <chrono>
#include <cstdio>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "run/run.hpp"

namespace ljmd {

/// Shows the progress of a run on stderr: on a terminal one line that is updated and never longer than the terminal is
/// wide, elsewhere a line at every tenth of the run. Rates are averages over the last seconds, so that they follow the
/// current stage.
class Progress : public RunListener {
  public:
    /// @param atoms  of a fluid, whose time is in tau. None: a few-body run, with time in the deck's units and no rate
    /// per atom
    /// @param quiet  print only warnings
    Progress(std::optional<Index> atoms, Index total_steps, bool quiet, Index first_step = 0);
    ~Progress() override;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void stage_begins(const Stage& stage) override;
    void step_done(Index step) override;
    void sampled(const ThermoRow& row) override;
    void sampled(const FewBodyRow& row) override;
    void errors(const std::vector<ErrorSoFar>& errors) override;
    void warning(const std::string& text) override;
    void doubted(const std::string& text) override;

    /// From now on print no doubts: the report that says them follows on the same terminal.
    void leave_doubts_to_report() { prints_doubts_ = false; }

    /// One line: "[production] 42 % step 10500/25000 4210 steps/s 3.64e+06 atom-steps/s ETA 0:03"; without the
    /// atom-steps for few bodies.
    [[nodiscard]] std::string line(Index step, double steps_per_second) const;

    /// The line on a terminal, with the values of the last sample: "[production]  42 %  10500/25000  4210 steps/s  ETA
    /// 0:03  T 0.7129  U/N -6.101  p 0.0807". Parts are left out until it is at most so many columns wide.
    [[nodiscard]] std::string line_within(std::size_t columns, Index step, double steps_per_second) const;

    /// Remove the line from the terminal, before something else is printed.
    void clear_line();

  private:
    using Clock = std::chrono::steady_clock;
    struct Mark {
        Clock::time_point time;
        Index step;
    };

    [[nodiscard]] double windowed_rate(const Mark& now);
    /// The first step at which this many tenths of the run are done.
    [[nodiscard]] Index step_of_tenth(Index tenth) const;
    [[nodiscard]] double done(Index step) const;
    [[nodiscard]] std::string time_left(Index step, double steps_per_second) const;

    std::optional<Index> atoms_;
    Index total_steps_;
    bool quiet_;
    bool prints_doubts_ = true;
    std::string stage_;
    std::vector<std::string> values_;  ///< of the last sample: "T 0.7129"
    std::vector<std::string> errors_;  ///< present ones and those wanted: "error of pressure 0.0061/0.005"
    std::deque<Mark> window_;
    Index next_look_ = 0;   ///< step at which to read the clock again: by time on a terminal, and at every tenth
    Index next_tenth_ = 1;  ///< the next tenth of the run; each is reported
    bool line_is_open_ = false;
};

}  // namespace ljmd
