#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/core/diagnostics.hpp"

namespace ljmd {

/// Where a sweep goes: the keys that it varies, and for each point their values, as `--set KEY=VALUE` takes them.
struct SweepPoints {
    std::vector<std::string> keys;
    std::vector<std::vector<std::string>> values;  ///< of each point, as many as there are keys

    bool operator==(const SweepPoints&) const = default;
};

// More are taken for a mistake.
inline constexpr std::size_t most_points = 10'000;
inline constexpr std::size_t most_varied_keys = 32;

/// Report too many keys, and those that are none, stand twice, or are given by --set, too: what is varied has no fixed
/// value.
/// @param from  what the keys stand in
void check_keys(const std::vector<std::string>& keys, const std::vector<std::string>& settings, const Location& from,
                Diagnostics& diagnostics);

/// The points of `--grid`: "KEY=FROM:TO:COUNT" or "KEY=A|B|C", several keys between commas or in several texts. All
/// combinations are points; the values of the last key follow each other.
///
/// FROM:TO:COUNT is COUNT >= 2 numbers at equal distances from FROM to TO, rounded to 14 digits, so that 0.3 is 0.3. A
/// list may hold whatever --set takes; separators in quotes or brackets separate nothing.
/// @param settings  of --set
/// @return no points when there are mistakes: each is one error
[[nodiscard]] SweepPoints grid_points(const std::vector<std::string>& grids, const std::vector<std::string>& settings,
                                      Diagnostics& diagnostics);

/// The points of `--list FILE`: CSV with a header of keys, each row a point. Blank lines are passed over.
/// @param settings  of --set
/// @return no points when there are mistakes: each is one error, located in its line
/// @throws DataError  the file cannot be read
[[nodiscard]] SweepPoints list_points(const std::filesystem::path& file, const std::vector<std::string>& settings,
                                      Diagnostics& diagnostics);

/// Keys as headings: their last parts, "temperature", or all of them where that is not enough to tell them apart.
/// @pre check_keys() finds nothing wrong with them, here and below
[[nodiscard]] std::vector<std::string> short_keys(const std::vector<std::string>& keys);

/// A name for each point, in which its values can be read, and which can be that of a directory:
/// "temperature=1.2,density=0.3". No two are the same, nor is one with ".log" behind it another one.
[[nodiscard]] std::vector<std::string> point_names(const SweepPoints& points);

/// The settings that make a point: "system.temperature=1.2", ...
[[nodiscard]] std::vector<std::string> point_settings(const SweepPoints& points, std::size_t point);

}  // namespace ljmd
