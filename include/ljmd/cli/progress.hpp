#pragma once

#include <chrono>
#include <cstdio>
#include <deque>
#include <optional>
#include <string>

#include "ljmd/run/run.hpp"

namespace ljmd {

/// Tells a person how far a run is, on stderr: on a terminal one line that renews itself, elsewhere a plain line at
/// every tenth of the run. Rates are over the last seconds, so that they follow the stage that is running.
class Progress : public RunListener {
  public:
    /// @param atoms  of a fluid, whose time is in tau. None: few bodies, whose time is in the deck's own unit, and
    /// whose
    ///               steps are as fast whatever they are
    /// @param quiet  say nothing but warnings
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
    /// The first step at which that many tenths of the run are done.
    [[nodiscard]] Index step_of_tenth(Index tenth) const;
    void clear_line();

    std::optional<Index> atoms_;
    Index total_steps_;
    bool quiet_;
    bool terminal_;
    std::string stage_;
    std::deque<Mark> window_;
    Index next_look_ = 0;   ///< step at which the clock is read again: on a terminal by time, and at every tenth
    Index next_tenth_ = 1;  ///< the next tenth of the run, which is always reported
    bool line_is_open_ = false;
};

}  // namespace ljmd
