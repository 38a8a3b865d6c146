#include "ljmd/deck/mistake_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ljmd {

namespace {

const Section& section_of(const Mistake& mistake, const Section& root) {
    if (mistake.table == "stage") {
        return root.sections("stage").at(mistake.index);
    }
    const Section& table = root.section(mistake.table);
    return mistake.table == "analysis" ? table.section(mistake.name) : table;
}

/// A key in the table that has it.
struct Place {
    const Section& table;
    std::string key;

    [[nodiscard]] bool is_sound() const { return table.sound(key); }
};

/// @param path  "cutoff", or "thermostat.type" for a key in a table of the section; a table that is absent is the place
Place place_of(const Section& section, const std::string& path) {
    const std::size_t dot = path.find('.');
    const std::string table = path.substr(0, dot);
    if (dot == std::string::npos || !section.has(table) || !section.sound(table)) {
        return {section, table};
    }
    return {section.section(table), path.substr(dot + 1)};
}

}  // namespace

void report(const std::vector<Mistake>& mistakes, const Section& root, Diagnostics& diagnostics) {
    for (const Mistake& mistake : mistakes) {
        const Section& section = section_of(mistake, root);
        const auto is_sound = [&](const std::string& key) { return place_of(section, key).is_sound(); };
        if (std::ranges::all_of(mistake.keys, is_sound)) {
            const auto [table, key] = place_of(section, mistake.keys.front());
            diagnostics.error(table.location(key),
                              mistake.follows_key ? fmt::format("'{}' in {} {}", key, table.title(), mistake.message)
                                                  : mistake.message,
                              mistake.hint);
        }
    }
}

}  // namespace ljmd
