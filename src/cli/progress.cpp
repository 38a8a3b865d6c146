#include "cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/streams.hpp"
#include "core/text.hpp"

namespace ljmd {

namespace {

constexpr double seconds_between_lines = 0.2;
constexpr double window_seconds = 5.0;
constexpr double longest_forecast = 1e12;  // [s]; fits into 64 bits, and is too long to matter
constexpr double most_steps_in_full = 1e6;
constexpr std::size_t stage_columns = 12;  // of a name on a terminal where it is too long

std::string duration(double seconds) {
    if (!(seconds < longest_forecast)) {
        return "?";
    }
    const auto s = static_cast<Index>(std::ceil(seconds));
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
                     : fmt::format("{}:{:02}", s / 60, s % 60);
}

/// "4210" rather than "4.21e+03"
std::string short_rate(double per_second) {
    return per_second >= 10.0 && per_second < most_steps_in_full ? fmt::format("{:.0f}", per_second)
                                                                 : fmt::format("{:.3g}", per_second);
}

/// Columns that a character takes at most: of those that are not ASCII some take two, and which ones depends on the
/// terminal.
std::size_t columns_of(const std::string& character) {
    return character.size() > 1 ? 2 : 1;
}

std::size_t width_of(const std::string& text) {
    std::size_t width = 0;
    for (const std::string& character : printable_characters(text)) {
        width += columns_of(character);
    }
    return width;
}

/// The beginning of a text that is at most so wide.
std::string cut(const std::string& text, std::size_t columns) {
    std::string beginning;
    std::size_t width = 0;
    for (const std::string& character : printable_characters(text)) {
        width += columns_of(character);
        if (width > columns) {
            break;
        }
        beginning += character;
    }
    return beginning;
}

/// A part of a line. Those with the highest number are left out first.
struct Part {
    std::string text;
    int dispensable;
};

std::string joined(const std::vector<Part>& parts) {
    std::string text;
    for (const Part& part : parts) {
        text += (text.empty() ? "" : "  ") + part.text;
    }
    return text;
}

}  // namespace

Progress::Progress(std::optional<Index> atoms, Index total_steps, bool quiet, Index first_step)
    : atoms_(atoms), total_steps_(total_steps), quiet_(quiet) {
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
    errors_.clear();
    if (!quiet_) {
        clear_line();
        print_message(fmt::format("stage '{}': {}{} steps of {:.6g}{}\n", stage.name,
                                  stage.until.empty() ? "" : "until errors are reached, at most ", stage.steps,
                                  stage.time_step, atoms_ ? " tau" : ""));
    }
}

void Progress::sampled(const ThermoRow& row) {
    values_.clear();
    if (row.values.temperature) {
        values_.push_back(fmt::format("T {:.4g}", *row.values.temperature));
    }
    values_.push_back(fmt::format("U/N {:.4g}", row.values.potential_energy));
    if (row.values.pressure) {
        values_.push_back(fmt::format("p {:.4g}", *row.values.pressure));
    }
}

void Progress::sampled(const FewBodyRow& row) {
    values_ = {fmt::format("E {:.6g}", row.values.total_energy)};
}

void Progress::errors(const std::vector<ErrorSoFar>& errors) {
    errors_.clear();
    for (const ErrorSoFar& found : errors) {
        errors_.push_back(
            std::isnan(found.error)
                ? fmt::format("error of {} ?/{:.3g}", found.wanted.observable, found.wanted.error)
                : fmt::format("error of {} {:.2g}/{:.3g}", found.wanted.observable, found.error, found.wanted.error));
    }
}

void Progress::step_done(Index step) {
    if (quiet_ || step < next_look_) {
        return;
    }
    const Mark now{Clock::now(), step};
    const double rate = windowed_rate(now);
    const Index tenth = step_of_tenth(next_tenth_);
    // Asked each time, because a terminal can be made narrower. Its last column stays free: a line that fills it leaves
    // the cursor in a place on which terminals do not agree.
    const std::optional<std::size_t> columns = message_columns();
    if (columns) {
        talk_over_line(line_within(*columns - 1, step, rate));
        line_is_open_ = true;
    } else if (step >= tenth) {
        print_message(line(step, rate) + '\n');
    }
    while (step >= step_of_tenth(next_tenth_) && next_tenth_ <= 10) {
        ++next_tenth_;
    }
    const auto soon = step + std::max<Index>(1, static_cast<Index>(0.5 * seconds_between_lines * rate));
    next_look_ = columns ? std::min(soon, step_of_tenth(next_tenth_)) : step_of_tenth(next_tenth_);
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

double Progress::done(Index step) const {
    return total_steps_ > 0 ? static_cast<double>(step) / static_cast<double>(total_steps_) : 1.0;
}

std::string Progress::time_left(Index step, double steps_per_second) const {
    return duration(static_cast<double>(total_steps_ - step) / steps_per_second);
}

std::string Progress::line(Index step, double steps_per_second) const {
    const std::string of_atoms =
        atoms_ ? fmt::format("  {:.3g} atom-steps/s", steps_per_second * static_cast<double>(*atoms_)) : "";
    std::string text = fmt::format("[{}] {:3.0f} % step {}/{}  {:.3g} steps/s{}  ETA {}", stage_, 100.0 * done(step),
                                   step, total_steps_, steps_per_second, of_atoms, time_left(step, steps_per_second));
    for (const std::string& error : errors_) {
        text += "  " + error;
    }
    return text;
}

std::string Progress::line_within(std::size_t columns, Index step, double steps_per_second) const {
    constexpr int never = 0;
    std::vector<Part> parts{{fmt::format("[{}]", stage_), 1},
                            {fmt::format("{:3.0f} %", 100.0 * done(step)), never},
                            {fmt::format("{}/{}", step, total_steps_), 7},
                            {fmt::format("{} steps/s", short_rate(steps_per_second)), 4}};
    if (atoms_) {
        parts.push_back({fmt::format("{:.3g} atom-steps/s", steps_per_second * static_cast<double>(*atoms_)), 8});
    }
    parts.push_back({fmt::format("ETA {}", time_left(step, steps_per_second)), 2});
    for (const std::string& error : errors_) {
        parts.push_back({error, 2});
    }
    int dispensable = 3;  // the first value stays longest; the rate is worth more than the others
    for (const std::string& value : values_) {
        parts.push_back({value, dispensable});
        dispensable = std::max(dispensable + 1, 5);
    }
    while (width_of(joined(parts)) > columns) {
        const auto first = std::ranges::max_element(parts, {}, &Part::dispensable);
        if (first->dispensable == never) {
            return cut(first->text, columns);
        }
        // Before something is left out that every line should have, the name of the stage is shortened.
        if (first->dispensable < 7 && width_of(stage_) > stage_columns && parts.front().dispensable == 1 &&
            width_of(parts.front().text) > stage_columns + 2) {
            parts.front().text = fmt::format("[{}]", cut(stage_, stage_columns));
        } else {
            parts.erase(first);
        }
    }
    return joined(parts);
}

void Progress::warning(const std::string& text) {
    clear_line();
    warn(text);
}

void Progress::doubted(const std::string& text) {
    if (prints_doubts_) {
        warning(text);
    }
}

void Progress::clear_line() {
    if (line_is_open_) {
        talk_over_line("");
        line_is_open_ = false;
    }
}

}  // namespace ljmd
