#pragma once

#include <string>
#include <vector>
#include "catch.hpp"

#include "input/deck_file.hpp"

namespace ljmd::test {

inline std::vector<std::string> formatted(const Diagnostics& diagnostics) {
    std::vector<std::string> all;
    for (const Diagnostic& diagnostic : diagnostics.entries()) all.push_back(format(diagnostic));
    return all;
}

/// The tables of a deck that must be good TOML.
inline Table parsed(const std::string& text) {
    Diagnostics diagnostics;
    Table table = parse_deck("d", text, diagnostics).table;
    CHECK(formatted(diagnostics).empty());
    return table;
}

/// A value that must be there.
inline const Value& at(const Table& table, const std::string& key) {
    const Entry* entry = find(table, key);
    REQUIRE(entry);
    return entry->value;
}

inline const Table& inner(const Table& table, const std::string& key) {
    return std::get<Table>(at(table, key).data);
}

}  // namespace ljmd::test
