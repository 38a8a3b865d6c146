#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// The points of a sweep: the varied keys, and for each point their values in the form of `--set KEY=VALUE`.
struct SweepPoints {
    std::vector<std::string> keys;
    std::vector<std::vector<std::string>> values;  ///< for each point, one value per key

    bool operator==(const SweepPoints&) const = default;
};

// Larger numbers count as mistakes.
inline constexpr std::size_t max_points = 10'000;
inline constexpr std::size_t max_varied_keys = 32;

/// Report too many keys, invalid keys, duplicates, and keys that are also given by --set: a varied key has no fixed
/// value.
/// @param from  location of the keys
void check_keys(const std::vector<std::string>& keys, const std::vector<std::string>& settings, const Location& from,
                Diagnostics& diagnostics);

/// The points of `--grid`: "KEY=FROM:TO:COUNT" or "KEY=A|B|C", several keys separated by commas or in several
/// arguments. All combinations are points; the last key varies fastest.
///
/// FROM:TO:COUNT means COUNT >= 2 equally spaced numbers from FROM to TO, rounded to 14 digits, so that 0.3 is 0.3. A
/// list may have any values of --set; separators in quotes or brackets do not count.
/// @param settings  arguments of --set
/// @return no points if there are mistakes; each mistake is one error
[[nodiscard]] SweepPoints grid_points(const std::vector<std::string>& grids, const std::vector<std::string>& settings,
                                      Diagnostics& diagnostics);

/// The values of one axis of a grid: "FROM:TO:COUNT", "A|B|C", or a single value.
/// @param where  location of the text, whose mistakes are errors there
/// @return no values if there are mistakes
[[nodiscard]] std::vector<std::string> axis_values(const std::string& text, const std::string& name,
                                                   const Location& where, Diagnostics& diagnostics);

/// The points of `--list FILE`: CSV with a header of keys, and one point per row. Blank lines are skipped.
/// @param settings  arguments of --set
/// @return no points if there are mistakes; each mistake is one error, located at its line
/// @throws DataError  the file cannot be read
[[nodiscard]] SweepPoints list_points(const std::filesystem::path& file, const std::vector<std::string>& settings,
                                      Diagnostics& diagnostics);

inline constexpr const char* seed_key = "system.seed";

/// The same points, each with a seed of its own: the given one, the next, and so on. Neighbouring seeds are as
/// independent as any.
/// @throws InputError  the seed is a varied key already, or the last seed is beyond 2^53 - 1, the largest of a deck
[[nodiscard]] SweepPoints with_seeds(SweepPoints points, std::uint64_t first);

/// Keys as headings: their last parts, "temperature", or the whole key if that is ambiguous.
/// @pre check_keys() accepts the keys, here and below
[[nodiscard]] std::vector<std::string> short_keys(const std::vector<std::string>& keys);

/// A name for each point that shows its values and is valid as a directory name: "temperature=1.2,density=0.3". Names
/// are unique, and none equals another one with ".log" appended.
[[nodiscard]] std::vector<std::string> point_names(const SweepPoints& points);

/// The settings of a point: "system.temperature=1.2", ...
[[nodiscard]] std::vector<std::string> point_settings(const SweepPoints& points, std::size_t point);

}  // namespace ljmd
