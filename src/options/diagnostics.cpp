#include "ljmd/detail/options/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/text.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {
namespace {

constexpr std::size_t max_errors_shown = 50;
constexpr std::size_t max_message = 400;
constexpr std::size_t max_line = 160;
constexpr std::size_t max_word = 64;

/// Orders diagnostics by source, line and column.
bool stands_before(const Diagnostic* a, const Diagnostic* b) {
    static const std::string no_source;
    const auto place = [](const Diagnostic& diagnostic) {
        const Location& where = diagnostic.location;
        return std::tie(where.source ? where.source->name : no_source, where.line, where.column);
    };
    return place(*a) < place(*b);
}

/// The line, and below it the underline followed by the hint.
std::string excerpt(const Location& where, const std::string& hint) {
    auto characters = printable_characters(line_of(where.source->text, where.line));
    std::size_t column = std::min(static_cast<std::size_t>(std::max(where.column, 1)) - 1, characters.size());
    std::string before;
    std::string behind;
    if (characters.size() > max_line) {
        const std::size_t first = std::min(column - std::min(column, max_line / 2), characters.size() - max_line);
        if (first > 0) before = "...";
        if (first + max_line < characters.size()) behind = "...";
        characters = {characters.begin() + static_cast<std::ptrdiff_t>(first),
                      characters.begin() + static_cast<std::ptrdiff_t>(first + max_line)};
        column -= first;
    }
    const std::size_t underlined = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(where.length, 1)), 1,
                                                           std::max<std::size_t>(characters.size() - column, 1));
    const std::string number = std::to_string(where.line);
    return fmt::format("  {} | {}{}{}\n  {} | {}{}{}{}", number, before, fmt::join(characters, ""), behind,
                       std::string(number.size(), ' '), std::string(before.size() + column, ' '),
                       std::string(underlined, '^'), hint.empty() ? "" : " ", hint);
}

}  // namespace

void Diagnostics::error(Location location, std::string message, std::string hint) {
    entries_.push_back({Severity::error, std::move(location), std::move(message), std::move(hint)});
}

void Diagnostics::warning(Location location, std::string message, std::string hint) {
    entries_.push_back({Severity::warning, std::move(location), std::move(message), std::move(hint)});
}

bool Diagnostics::has_errors() const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [](const Diagnostic& entry) { return entry.severity == Severity::error; });
}

void Diagnostics::throw_if_errors() const {
    std::vector<const Diagnostic*> errors;
    for (const Diagnostic& entry : entries_) {
        if (entry.severity == Severity::error) errors.push_back(&entry);
    }
    if (errors.empty()) return;
    std::stable_sort(errors.begin(), errors.end(), stands_before);
    std::string text;
    for (std::size_t i = 0; i < std::min(errors.size(), max_errors_shown); ++i) text += format(*errors[i]) + "\n";
    if (errors.size() > max_errors_shown) text += fmt::format("... and {} more\n", errors.size() - max_errors_shown);
    throw InputError(fmt::format("{}{} error{}. Nothing was run.", text, errors.size(), errors.size() == 1 ? "" : "s"));
}

std::string Diagnostics::errors_without_places() const {
    std::string text;
    for (const Diagnostic& entry : entries_) {
        if (entry.severity == Severity::error) {
            text += (text.empty() ? "" : "\n") + entry.message + (entry.hint.empty() ? "" : ": " + entry.hint);
        }
    }
    return text;
}

std::string format(const Diagnostic& diagnostic) {
    const Location& where = diagnostic.location;
    const bool has_line = where.source && where.line > 0;
    const std::string hint = printable(diagnostic.hint, max_message);
    std::string text = diagnostic.severity == Severity::error ? "error: " : "warning: ";
    if (where.source) text += printable(where.source->name, max_message);
    if (has_line) text += fmt::format(":{}:{}", where.line, where.column);
    if (where.source) text += ": ";
    text += printable(diagnostic.message, max_message);
    if (has_line) return text + "\n" + excerpt(where, hint);
    return hint.empty() ? text : text + "\n  " + hint;
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
    std::string nearest;
    std::size_t least = max_word;
    for (const std::string& word : candidates) {
        const std::size_t longer = std::max(name.size(), word.size());
        if (longer > max_word) continue;
        // Rows i - 2, i - 1 and i of the table of distances between the first i and the first j letters of the two
        // words.
        std::vector<std::size_t> before(word.size() + 1), last(word.size() + 1), row(word.size() + 1);
        for (std::size_t j = 0; j <= word.size(); ++j) row[j] = j;
        for (std::size_t i = 1; i <= name.size(); ++i) {
            before.swap(last);
            last.swap(row);
            row[0] = i;
            for (std::size_t j = 1; j <= word.size(); ++j) {
                row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (name[i - 1] == word[j - 1] ? 0 : 1)});
                const bool swapped = i > 1 && j > 1 && name[i - 1] == word[j - 2] && name[i - 2] == word[j - 1];
                if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        const std::size_t distance = row[word.size()];
        if (distance <= (longer + 2) / 3 && distance < least) {
            least = distance;
            nearest = word;
        }
    }
    return nearest;
}

}  // namespace ljmd
