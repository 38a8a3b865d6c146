#pragma once

#include <optional>
#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/options/schema.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

/// Context for checking one value. It holds references that are valid during the call of validate().
struct KeyContext {
    const Key& key;
    const std::string& title;  ///< title of the table
    const std::optional<SubstanceUnits>& units;
    Diagnostics& diagnostics;
    Index component = 0;  ///< component of a vector, from 1; 0 for a value as a whole

    /// "'density' in [system]", "component 2 of 'position' in [[body]]": the beginning of every message.
    [[nodiscard]] std::string subject() const;
};

[[nodiscard]] bool is_table_kind(Kind kind);

/// "an integer", "a table", "an array of 1 to 3 numbers": what a value of the key must be.
[[nodiscard]] std::string expected_kind(const Key& key);

/// Hint with the range, choices, units or header of a key; empty if everything is allowed.
[[nodiscard]] std::string allowed_hint(const Key& key);

/// Report "'steps' in [[stage]] must be an integer, found a float".
void report_wrong_kind(const KeyContext& context, const Value& value);

/// Value that replaces a wrong one of a non-table key: its default, or one that it allows.
[[nodiscard]] PlainValue fallback_value(const Key& key);

/// Check and convert the value of a non-table key. Kind::number becomes a double in reduced units (-0 as +0),
/// Kind::quantity a double in SI, Kind::vector as many doubles as allowed, other kinds bool, int64 or string. Each
/// mistake is reported, a component's at its own place. The result always has the type of the key, and lies in its
/// range if the range holds any number.
[[nodiscard]] PlainValue checked_value(const KeyContext& context, const Value& value);

}  // namespace ljmd
