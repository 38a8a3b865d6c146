#pragma once

#include <optional>
#include <string>

#include "ljmd/core/schema.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/core/value.hpp"

namespace ljmd {

/// What the check of one value needs to know. Holds references: lives as long as the call of validate().
struct KeyContext {
    const Key& key;
    const std::string& title;  ///< of the table
    const std::optional<SubstanceUnits>& units;
    Diagnostics& diagnostics;
    Index component = 0;  ///< which number of a vector is checked, from 1; 0 for a value as a whole

    /// "'density' in [system]", "component 2 of 'position' in [[body]]": how every message begins.
    [[nodiscard]] std::string subject() const;
};

[[nodiscard]] bool is_table_kind(Kind kind);

/// "an integer", "a table", "an array of 1 to 3 numbers": what a value of the key has to be.
[[nodiscard]] std::string expected_kind(const Key& key);

/// The range, the choices, the units or the header of a key as a hint; empty when anything goes.
[[nodiscard]] std::string allowed_hint(const Key& key);

/// Report "'steps' in [[stage]] must be an integer, found a float".
void report_wrong_kind(const KeyContext& context, const Value& value);

/// A value of a key that is no table, to go on with after a mistake: its default, or one that it allows.
[[nodiscard]] PlainValue fallback_value(const Key& key);

/// Check the value of a key that is no table, and convert it: to double for Kind::number (reduced units, -0 as +0) and
/// Kind::quantity (SI), to as many doubles as allowed for Kind::vector, to bool, int64 or string for the others. Each
/// mistake is reported, that of a component at its own place; what returns is always of the key's type, and in its
/// range wherever the range holds a number at all.
[[nodiscard]] PlainValue checked_value(const KeyContext& context, const Value& value);

}  // namespace ljmd
