#include "ljmd/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "ljmd/cli/streams.hpp"

namespace ljmd {

namespace {

constexpr double seconds_between_lines = 0.2;
constexpr double window_seconds = 5.0;
constexpr double longest_forecast = 1e12;  // [s]; fits into 64 bits, and is too long to matter

std::string duration(double seconds) {
    if (!(seconds < longest_forecast)) {
        return "?";
    }
    const auto s = static_cast<Index>(std::ceil(seconds));
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
                     : fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

Progress::Progress(std::optional<Index> atoms, Index total_steps, bool quiet, Index first_step)
    : atoms_(atoms), total_steps_(total_steps), quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {
    window_.push_back({Clock::now(), first_step});
    while (step_of_tenth(next_tenth_) <= first_step && next_tenth_ <= 10) {
        ++next_tenth_;
    }
}

Progress::~Progress() {
    clear_line();
}

void Progress::stage_begins(const Stage& stage) {
    stage_ = stage.name;
    if (!quiet_) {
        clear_line();
        print_message(fmt::format("stage '{}': {} steps of {:.6g}{}\n", stage.name, stage.steps, stage.time_step,
                                  atoms_ ? " tau" : ""));
    }
}

void Progress::step_done(Index step) {
    if (quiet_ || step < next_look_) {
        return;
    }
    const Mark now{Clock::now(), step};
    const double rate = windowed_rate(now);
    const Index tenth = step_of_tenth(next_tenth_);
    if (terminal_) {
        talk_over_line(line(step, rate));
        line_is_open_ = true;
    } else if (step >= tenth) {
        print_message(line(step, rate) + '\n');
    }
    while (step >= step_of_tenth(next_tenth_) && next_tenth_ <= 10) {
        ++next_tenth_;
    }
    const auto soon = step + std::max<Index>(1, static_cast<Index>(0.5 * seconds_between_lines * rate));
    next_look_ = terminal_ ? std::min(soon, step_of_tenth(next_tenth_)) : step_of_tenth(next_tenth_);
}

Index Progress::step_of_tenth(Index tenth) const {
    return static_cast<Index>(std::ceil(0.1 * static_cast<double>(tenth) * static_cast<double>(total_steps_)));
}

double Progress::windowed_rate(const Mark& now) {
    window_.push_back(now);
    const auto seconds_since = [&](const Mark& mark) {
        return std::chrono::duration<double>(now.time - mark.time).count();
    };
    while (window_.size() > 2 && seconds_since(window_[1]) > window_seconds) {
        window_.pop_front();
    }
    const double seconds = seconds_since(window_.front());
    return seconds > 0.0 ? static_cast<double>(now.step - window_.front().step) / seconds : 0.0;
}

std::string Progress::line(Index step, double steps_per_second) const {
    const double done = total_steps_ > 0 ? static_cast<double>(step) / static_cast<double>(total_steps_) : 1.0;
    const std::string of_atoms =
        atoms_ ? fmt::format("  {:.3g} atom-steps/s", steps_per_second * static_cast<double>(*atoms_)) : "";
    return fmt::format("[{}] {:3.0f} % step {}/{}  {:.3g} steps/s{}  ETA {}", stage_, 100.0 * done, step, total_steps_,
                       steps_per_second, of_atoms,
                       duration(static_cast<double>(total_steps_ - step) / steps_per_second));
}

void Progress::warning(const std::string& text) {
    clear_line();
    warn(text);
}

void Progress::clear_line() {
    if (line_is_open_) {
        talk_over_line("");
        line_is_open_ = false;
    }
}

}  // namespace ljmd
