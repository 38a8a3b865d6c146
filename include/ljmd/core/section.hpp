#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/schema.hpp"
#include "ljmd/core/value.hpp"

namespace ljmd {

/// How often something happens: one of the two.
struct Interval {
    std::optional<std::int64_t> steps;
    std::optional<double> seconds;  ///< of wall time
};

/// One table of a deck after validation: every key of the schema has a value of the right type in its allowed range,
/// in reduced units, or is an absent optional key. Knows where each value stands, so that later checks can point at it.
class Section {
  public:
    /// Values. @throws ContractViolation when the schema has no such key of that kind, or when the key is absent.
    [[nodiscard]] bool flag(const std::string& key) const;
    [[nodiscard]] std::int64_t integer(const std::string& key) const;
    [[nodiscard]] double number(const std::string& key) const;            ///< reduced units; for Kind::quantity SI
    [[nodiscard]] const std::string& text(const std::string& key) const;  ///< text and choice
    [[nodiscard]] Interval interval(const std::string& key) const;
    [[nodiscard]] const std::vector<double>& vector(const std::string& key) const;
    [[nodiscard]] const Section& section(const std::string& key) const;
    [[nodiscard]] const std::vector<Section>& sections(const std::string& key) const;

    /// True when the key was given or has a default.
    [[nodiscard]] bool has(const std::string& key) const;

    /// False when validation found the key missing, misspelled or its value wrong (reported by then): what the Section
    /// holds is a stand-in, which says nothing about the deck. The table of a key is sound though keys in it are not.
    [[nodiscard]] bool sound(const std::string& key) const;

    /// Where the value stands (the table itself when the key is absent, defaulted or not of the schema).
    [[nodiscard]] Location location(const std::string& key) const;
    [[nodiscard]] const Location& location() const { return location_; }
    [[nodiscard]] const std::string& title() const { return title_; }

  private:
    friend Section validate(const Table&, const Location&, const Schema&, const std::optional<SubstanceUnits>&,
                            Diagnostics&);

    struct Item {
        Kind kind;
        std::optional<PlainValue> value;
        std::vector<Section> sections;
        Location location;
        bool present = false;
        bool sound = true;
    };
    [[nodiscard]] const Item& item(const std::string& key, Kind kind) const;

    std::string title_;
    Location location_;
    std::map<std::string, Item> items_;
};

/// Check a table against its schema and convert it. Every mistake becomes one diagnostic: unknown key (with the nearest
/// known one), missing key, wrong type ("must be an integer, found a float"), value out of range, not finite, unknown
/// choice (with all choices), an array of a wrong length, a unit that is unknown or of the wrong dimension, a unit
/// without [argon]. A missing key that an unknown one was probably meant to be is not reported a second time.
///
/// Nothing is thrown: after a mistake the Section holds a value that is safe to use (the nearest allowed one, or the
/// default), so that checking can go on and all mistakes are found in one pass.
///
/// @param units  conversion for strings with units; empty when the deck has no [argon]
[[nodiscard]] Section validate(const Table& table, const Location& where, const Schema& schema,
                               const std::optional<SubstanceUnits>& units, Diagnostics& diagnostics);

}  // namespace ljmd
