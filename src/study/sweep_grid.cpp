#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "core/text.hpp"
#include "ljmd/core/types.hpp"
#include "study/sweep_points.hpp"

namespace ljmd {

namespace {

constexpr int digits = 14;  // of the numbers in a range

/// A key of a grid and its values.
struct Axis {
    std::string key;
    std::vector<std::string> values;
};

/// The parts of a text, without blanks around them; separators in quotes or brackets do not count.
std::vector<std::string> parts_of(std::string_view text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    int depth = 0;
    char quote = '\0';
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != '\0') {
            quote = c == quote ? '\0' : quote;
        } else if ((c == '"' || c == '\'') && (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0)) {
            quote = c;  // within a word it is an apostrophe
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            depth = std::max(depth - 1, 0);
        } else if (c == separator && depth == 0) {
            parts.emplace_back(trimmed(text.substr(begin, i - begin)));
            begin = i + 1;
        }
    }
    parts.emplace_back(trimmed(text.substr(begin)));
    return parts;
}

/// `count` equally spaced numbers. Those between the ends are rounded to 14 digits of the larger end.
std::vector<std::string> numbers(double from, double to, Index count) {
    const double largest = std::max(std::abs(from), std::abs(to));
    const int decimals = std::max(0, digits - static_cast<int>(std::ceil(std::log10(largest))));
    std::vector<std::string> values;
    for (Index k = 0; k < count; ++k) {
        double value = std::lerp(from, to, static_cast<double>(k) / static_cast<double>(count - 1));
        if (k > 0 && k + 1 < count) {
            value = to_number(fmt::format("{:.{}f}", value, decimals)).value_or(value);
        }
        values.push_back(fmt::format("{}", value == 0.0 ? 0.0 : value));  // no "-0"
    }
    return values;
}

/// The values of FROM:TO:COUNT; none, with errors, if it is invalid.
std::vector<std::string> range(const std::vector<std::string>& parts, const Location& where, Diagnostics& diagnostics) {
    constexpr const char* form = "FROM:TO:COUNT, as in 0.1:0.9:9; a list of values has the form A|B|C";
    if (parts.size() != 3) {
        diagnostics.error(where, fmt::format("a range has 3 parts, found {}", parts.size()), form);
        return {};
    }
    const auto from = to_number(parts[0]);
    const auto to = to_number(parts[1]);
    for (int end = 0; end < 2; ++end) {
        if (!(end == 0 ? from : to)) {
            diagnostics.error(where,
                              fmt::format("{} is {}, which is no finite number", end == 0 ? "FROM" : "TO",
                                          in_quotes(parts[end == 0 ? 0 : 1])),
                              form);
        }
    }
    Index count = 0;
    const char* all = parts[2].data() + parts[2].size();
    const auto [end, error] = std::from_chars(parts[2].data(), all, count);
    if (error != std::errc() || end != all || count < 2 || count > static_cast<Index>(max_points)) {
        diagnostics.error(
            where, fmt::format("COUNT is {}, must be a whole number from 2 to {}", in_quotes(parts[2]), max_points),
            form);
        return {};
    }
    if (from && to && *from == *to) {
        diagnostics.error(where, fmt::format("FROM and TO are both {}", *from), form);
        return {};
    }
    return from && to ? numbers(*from, *to, count) : std::vector<std::string>{};
}

/// A key with its values; no values, with errors, if there is a mistake.
Axis read_axis(const std::string& text, const Location& where, Diagnostics& diagnostics) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        diagnostics.error(where, fmt::format("{} has not the form KEY=FROM:TO:COUNT or KEY=A|B|C", in_quotes(text)),
                          "a value that holds a comma stands in quotes or brackets");
        return {};
    }
    const std::string key(trimmed(text.substr(0, equals)));
    return {key, axis_values(text.substr(equals + 1), key, where, diagnostics)};
}

/// KEY=A, then values alone: "density=0.1,0.2,0.3" cut at its commas.
bool of_one_key(const std::vector<std::string>& parts) {
    const auto is_axis = [](const std::string& part) { return part.find('=') != std::string::npos; };
    return parts.size() > 1 && is_axis(parts.front()) && std::none_of(parts.begin() + 1, parts.end(), is_axis);
}

/// All combinations; the last axis varies fastest.
SweepPoints combinations(const std::vector<Axis>& axes) {
    SweepPoints points{{}, {{}}};
    for (const Axis& axis : axes) {
        points.keys.push_back(axis.key);
        std::vector<std::vector<std::string>> longer;
        for (const auto& values : points.values) {
            for (const std::string& value : axis.values) {
                longer.push_back(values);
                longer.back().push_back(value);
            }
        }
        points.values = std::move(longer);
    }
    return points;
}

}  // namespace

std::vector<std::string> axis_values(const std::string& text, const std::string& name, const Location& where,
                                     Diagnostics& diagnostics) {
    std::vector<std::string> values = parts_of(text, '|');
    if (values.size() == 1) {
        if (const auto parts = parts_of(text, ':'); parts.size() > 1) {
            values = range(parts, where, diagnostics);
        }
    }
    std::set<std::string> found;
    for (const std::string& value : values) {
        if (value.empty()) {
            diagnostics.error(where, fmt::format("{} has an empty value", in_quotes(name)));
            return {};
        }
        if (!found.insert(value).second) {
            diagnostics.error(where, fmt::format("{} has the value {} twice", in_quotes(name), in_quotes(value)));
            return {};
        }
    }
    return values;
}

SweepPoints grid_points(const std::vector<std::string>& grids, const std::vector<std::string>& settings,
                        Diagnostics& diagnostics) {
    std::vector<Axis> axes;
    std::size_t count = 1;
    for (const std::string& grid : grids) {
        const Location where{std::make_shared<const Source>(Source{"--grid " + grid, grid})};
        const std::vector<std::string> parts = parts_of(grid, ',');
        if (std::ranges::none_of(parts, [](const std::string& part) { return part.empty(); }) && of_one_key(parts)) {
            diagnostics.error(where, "the values of one key are separated by |",
                              fmt::format("'{}'", fmt::join(parts, "|")));
            return {};
        }
        for (const std::string& text : parts) {
            axes.push_back(read_axis(text, where, diagnostics));
            count = std::min(count * axes.back().values.size(), max_points + 1);
        }
    }
    const Location whole{std::make_shared<const Source>(Source{"--grid", ""})};
    std::vector<std::string> keys;
    keys.reserve(axes.size());
    for (const Axis& axis : axes) {
        keys.push_back(axis.key);
    }
    if (!diagnostics.has_errors()) {
        check_keys(keys, settings, whole, diagnostics);
    }
    if (count > max_points) {
        diagnostics.error(whole, fmt::format("too many points, at most {} are allowed", max_points));
    }
    return diagnostics.has_errors() ? SweepPoints{} : combinations(axes);
}

}  // namespace ljmd
