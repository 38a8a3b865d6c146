#pragma once

#include <chrono>
#include <cstdio>
#include <deque>
#include <optional>
#include <string>

#include "ljmd/run/run.hpp"

namespace ljmd {

/// Shows the progress of a run on stderr: on a terminal one line that is updated, elsewhere a line at every tenth of
/// the run. Rates are averages over the last seconds, so that they follow the current stage.
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
    void warning(const std::string& text) override;

    /// One line: "[production] 42 % step 10500/25000 4210 steps/s 3.64e+06 atom-steps/s ETA 0:03"; without the
    /// atom-steps for few bodies.
    [[nodiscard]] std::string line(Index step, double steps_per_second) const;

  private:
    using Clock = std::chrono::steady_clock;
    struct Mark {
        Clock::time_point time;
        Index step;
    };

    [[nodiscard]] double windowed_rate(const Mark& now);
    /// The first step at which this many tenths of the run are done.
    [[nodiscard]] Index step_of_tenth(Index tenth) const;
    void clear_line();

    std::optional<Index> atoms_;
    Index total_steps_;
    bool quiet_;
    bool terminal_;
    std::string stage_;
    std::deque<Mark> window_;
    Index next_look_ = 0;   ///< step at which to read the clock again: by time on a terminal, and at every tenth
    Index next_tenth_ = 1;  ///< the next tenth of the run; each is reported
    bool line_is_open_ = false;
};

}  // namespace ljmd
