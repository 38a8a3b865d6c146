#include "study/sweep_sense.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <map>

#include "deck/deck_system.hpp"
#include "deck/start_sense.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::size_t max_named = 3;  // number of points named in a mistake

/// The diagnostics of one point, as `ljmd check` would report them.
Diagnostics look_at(const Source& deck, const std::vector<std::string>& settings, bool force) {
    Diagnostics found;
    const auto loaded = load_deck_text(deck.name, deck.text, settings, force, found);
    if (loaded && loaded->start_file) {
        try {
            const Start start = find_start(*loaded);
            check_start(*loaded, start, found);
        } catch (const DataError& error) {
            found.error({}, error.what());
        }
    }
    return found;
}

/// A text with every number replaced by '#'.
std::string without_numbers(const std::string& text) {
    constexpr std::string_view of_numbers = "0123456789.+-e";
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find_first_not_of(of_numbers, i), text.size());
        const std::string run = text.substr(i, end - i);
        result += run.find_first_of("0123456789") == std::string::npos ? run : "#";
        result += end < text.size() ? text.substr(end, 1) : "";
        i = end + 1;
    }
    return result;
}

/// A mistake and the points that have it.
struct SharedMistake {
    Diagnostic first;
    std::vector<std::size_t> points;
};

std::string points_in_words(const std::vector<std::size_t>& points, const std::vector<std::string>& names) {
    if (points.size() == names.size()) {
        return points.size() == 1 ? "" : fmt::format(" (all {} points)", points.size());
    }
    std::vector<std::string> named;
    for (std::size_t k = 0; k < std::min(points.size(), max_named); ++k) {
        named.push_back(names[points[k]]);
    }
    const std::size_t others = points.size() - named.size();
    return fmt::format(" ({}{})", fmt::join(named, "; "),
                       others == 0 ? "" : fmt::format(" and {} other point{}", others, others == 1 ? "" : "s"));
}

}  // namespace

void check_points(const Source& deck, const std::vector<std::string>& settings, const SweepPoints& points,
                  const std::string& option, bool force, Diagnostics& diagnostics) {
    std::vector<SharedMistake> mistakes;
    std::map<std::string, std::size_t> known;
    for (std::size_t point = 0; point < points.values.size(); ++point) {
        const std::vector<std::string> varied = point_settings(points, point);
        std::vector<std::string> all = settings;
        all.insert(all.end(), varied.begin(), varied.end());
        const Diagnostics found = look_at(deck, all, force);
        for (Diagnostic entry : found.entries()) {
            Location& where = entry.location;
            for (std::size_t k = 0; k < varied.size(); ++k) {
                if (where.source && where.source->name == "--set " + varied[k]) {
                    where.source = std::make_shared<const Source>(Source{option + " " + points.keys[k], ""});
                }
            }
            const std::string what = fmt::format("{} {}:{}:{} {} {}", entry.severity == Severity::error,
                                                 where.source ? where.source->name : "", where.line, where.column,
                                                 without_numbers(entry.message), without_numbers(entry.hint));
            const auto [place, is_new] = known.emplace(what, mistakes.size());
            if (is_new) {
                mistakes.push_back({std::move(entry), {}});
            }
            std::vector<std::size_t>& having = mistakes[place->second].points;
            if (having.empty() || having.back() != point) {
                having.push_back(point);
            }
        }
    }
    const std::vector<std::string> names = point_names(points);
    for (const auto& [first, having] : mistakes) {
        const std::string message = first.message + points_in_words(having, names);
        if (first.severity == Severity::error) {
            diagnostics.error(first.location, message, first.hint);
        } else {
            diagnostics.warning(first.location, message, first.hint);
        }
    }
}

}  // namespace ljmd
