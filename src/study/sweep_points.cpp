#include "study/sweep_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/text.hpp"
#include "input/deck_setting.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_name = 200;  // of a directory name; file systems allow 255 bytes

/// A text as part of a name: characters that are special to shells or file systems become '-'.
std::string as_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        const bool kept = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
                          c == '_' || c == '+' || c == '-';
        name += kept ? c : '-';
    }
    return name;
}

}  // namespace

void check_keys(const std::vector<std::string>& keys, const std::vector<std::string>& settings, const Location& from,
                Diagnostics& diagnostics) {
    if (keys.size() > max_varied_keys) {
        diagnostics.error(from, fmt::format("{} keys, at most {} are allowed", keys.size(), max_varied_keys));
        return;
    }
    std::set<std::vector<std::string>> given;
    for (const std::string& setting : settings) {
        given.insert(setting_key(setting.substr(0, setting.find('='))));
    }
    std::set<std::vector<std::string>> varied;
    for (const std::string& key : keys) {
        const std::vector<std::string> parts = setting_key(key);
        if (parts.empty() || key.find('=') != std::string::npos) {
            diagnostics.error(from, fmt::format("{} is no key of a deck", in_quotes(key)),
                              "keys are written as --set takes them: system.density");
        } else if (!varied.insert(parts).second) {
            diagnostics.error(from, fmt::format("the key {} stands twice", in_quotes(key)));
        } else if (given.contains(parts)) {
            diagnostics.error(from, fmt::format("{} is varied, and given by --set as well", in_quotes(key)));
        }
    }
}

SweepPoints with_seeds(SweepPoints points, std::uint64_t first) {
    constexpr std::uint64_t largest = (std::uint64_t{1} << 53U) - 1;
    if (std::ranges::find(points.keys, seed_key) != points.keys.end()) {
        throw InputError(fmt::format("--seeds gives each point a seed of its own, but '{}' is varied", seed_key));
    }
    if (first > largest - points.values.size()) {
        throw InputError(fmt::format("--seeds counts up from the deck's seed, {}: {} points go beyond the largest seed",
                                     first, points.values.size()));
    }
    points.keys.emplace_back(seed_key);
    for (std::vector<std::string>& values : points.values) {
        values.push_back(fmt::format("{}", first++));
    }
    return points;
}

std::vector<std::string> short_keys(const std::vector<std::string>& keys) {
    std::vector<std::string> last;
    last.reserve(keys.size());
    for (const std::string& key : keys) {
        last.push_back(setting_key(key).back());
    }
    std::vector<std::string> headings;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        headings.push_back(std::count(last.begin(), last.end(), last[k]) > 1 ? keys[k] : last[k]);
    }
    return headings;
}

std::vector<std::string> point_names(const SweepPoints& points) {
    const std::vector<std::string> keys = short_keys(points.keys);
    std::set<std::string> taken;
    std::map<std::string, int> numbers;  ///< the last number appended to each name to make it unique
    std::vector<std::string> names;
    for (const auto& values : points.values) {
        std::string wanted;
        for (std::size_t k = 0; k < keys.size(); ++k) {
            wanted += fmt::format("{}{}={}", k == 0 ? "" : ",", as_name(keys[k]), as_name(values[k]));
        }
        wanted.resize(std::min(wanted.size(), longest_name));
        std::string name = wanted;
        const auto is_taken = [&] { return taken.contains(name) || taken.contains(name + ".log"); };
        for (int& number = numbers.try_emplace(wanted, 1).first->second; is_taken();) {
            name = fmt::format("{}-{}", wanted, ++number);
        }
        taken.insert({name, name + ".log"});
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> point_settings(const SweepPoints& points, std::size_t point) {
    std::vector<std::string> settings;
    for (std::size_t k = 0; k < points.keys.size(); ++k) {
        settings.push_back(fmt::format("{}={}", points.keys[k], points.values[point][k]));
    }
    return settings;
}

}  // namespace ljmd
