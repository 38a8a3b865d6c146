#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "ljmd/core/schema.hpp"
#include "ljmd/core/value.hpp"

namespace ljmd {

using Scalar = std::variant<bool, std::int64_t, double, std::string>;

/// What the check of one value needs to know. Holds references: lives as long as the call of validate().
struct KeyContext {
    const Key& key;
    const std::string& title;  ///< of the table
    const std::optional<SubstanceUnits>& units;
    Diagnostics& diagnostics;

    /// "'density' in [system]": how every message begins.
    [[nodiscard]] std::string subject() const;
};

[[nodiscard]] bool is_table_kind(Kind kind);

/// "an integer", "a table": what a value of that kind has to be.
[[nodiscard]] std::string expected_kind(Kind kind);

/// The range, the choices, the units or the header of a key as a hint; empty when anything goes.
[[nodiscard]] std::string allowed_hint(const Key& key);

/// Report "'steps' in [[stage]] must be an integer, found a float".
void report_wrong_kind(const KeyContext& context, const Value& value);

/// A value of a key that is no table, to go on with after a mistake: its default, or one that it allows.
[[nodiscard]] Scalar fallback_value(const Key& key);

/// Check the value of a key that is no table, and convert it: to double for Kind::number (reduced units, -0 as +0) and
/// Kind::quantity (SI), to bool, int64 or string for the others. Each mistake is reported; what returns is always of
/// the key's type, and in its range wherever the range holds a number at all.
[[nodiscard]] Scalar checked_value(const KeyContext& context, const Value& value);

}  // namespace ljmd
