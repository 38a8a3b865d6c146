#include "deck/mistake_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// The table that a mistake is in.
template <class Tables>
const Section& section_of(const Mistake& mistake, const Placed<Tables>& tables) {
    const bool is_body =
        std::is_same_v<Tables, FewBodyTables> && mistake.table == Placed<FewBodyTables>::key(&FewBodyTables::bodies);
    if (is_body || mistake.table == Placed<Tables>::key(&Tables::stages)) {
        return tables.section().sections(mistake.table).at(mistake.index);
    }
    const Section& table = tables.section().section(mistake.table);
    return mistake.table == Placed<Tables>::key(&Tables::analysis) ? table.section(mistake.name) : table;
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
    const bool is_within = dot != std::string::npos && section.has(table) && section.sound(table);
    const Place place = is_within ? Place{section.section(table), path.substr(dot + 1)} : Place{section, table};
    if (!place.table.knows(place.key)) {
        throw ContractViolation("a mistake in '" + path + "', which is no key of " + section.title());
    }
    return place;
}

template <class Tables>
void report_in(const Placed<Tables>& tables, const std::vector<Mistake>& mistakes, Diagnostics& diagnostics) {
    for (const Mistake& mistake : mistakes) {
        const Section& section = section_of(mistake, tables);
        const auto is_sound = [&](const std::string& key) { return place_of(section, key).is_sound(); };
        if (mistake.keys.empty()) {
            diagnostics.error(section.location(), mistake.message, mistake.hint);
        } else if (std::ranges::all_of(mistake.keys, is_sound)) {
            const auto [table, key] = place_of(section, mistake.keys.front());
            diagnostics.error(table.location(key),
                              mistake.follows_key ? fmt::format("'{}' in {} {}", key, table.title(), mistake.message)
                                                  : mistake.message,
                              mistake.hint);
        }
    }
}

}  // namespace

void report(const std::vector<Mistake>& mistakes, const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    report_in(tables, mistakes, diagnostics);
}

void report(const std::vector<Mistake>& mistakes, const Placed<FewBodyTables>& tables, Diagnostics& diagnostics) {
    report_in(tables, mistakes, diagnostics);
}

}  // namespace ljmd
