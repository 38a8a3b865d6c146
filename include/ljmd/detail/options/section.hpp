#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/options/description.hpp"
#include "ljmd/detail/options/schema.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

/// Every how many steps something happens, and where that is written.
struct StepInterval {
    Index every;
    Location location;
};

/// A table of a deck after validation. Every key of the schema has a value of the right type, in its allowed range and
/// in reduced units, or is optional and absent. The places of values are known, so that later checks can point at them.
class Section {
  public:
    /// Value of a key of any kind but tables: numbers in reduced units, but for Kind::quantity, which is in SI.
    /// @throws ContractViolation if the schema has no such key, or if it is absent
    [[nodiscard]] const PlainValue& plain(const std::string& key) const;

    /// Inner tables. @throws ContractViolation if the schema has no such key of that kind, or if the key is absent
    [[nodiscard]] const Section& section(const std::string& key) const;
    [[nodiscard]] const std::vector<Section>& sections(const std::string& key) const;

    /// True if the key was given or has a default.
    [[nodiscard]] bool has(const std::string& key) const;

    /// True if the schema has the key, also if it is absent.
    [[nodiscard]] bool knows(const std::string& key) const;

    /// False if validation found the key missing or misspelled, or its value wrong, and reported it. The value in the
    /// Section is then a stand-in that says nothing about the deck. A table can be sound although keys in it are not.
    [[nodiscard]] bool sound(const std::string& key) const;

    /// The same of all keys of the table.
    [[nodiscard]] bool all_sound() const;

    /// Whether the deck or a --set contains the key, so that its value is not the default.
    [[nodiscard]] bool written(const std::string& key) const;

    /// The value of the first key that is a step interval (see Key::step_interval) and has a value.
    [[nodiscard]] std::optional<StepInterval> step_interval() const;

    /// Place of the value; place of the table if the key is absent, defaulted or unknown to the schema.
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
        bool is_step_interval = false;
    };
    [[nodiscard]] const Item& item(const std::string& key, Kind kind) const;

    std::string title_;
    Location location_;
    std::map<std::string, Item> items_;
};

/// Check a table against its schema and convert it. Every mistake becomes one diagnostic: an unknown key (with the
/// nearest known one), a missing key, a wrong type ("must be an integer, found a float"), a value that is out of range
/// or not finite, an unknown choice (with all choices), an array of a wrong length, a unit that is unknown or of the
/// wrong dimension, a unit without [argon]. A missing key is not reported if an unknown one was probably meant to be
/// it.
///
/// Throws nothing. After a mistake the Section holds a value that is safe to use (the nearest allowed one, or the
/// default), so that one pass finds all mistakes.
///
/// @param units  conversion for strings with units; empty if the deck has no [argon]
[[nodiscard]] Section validate(const Table& table, const Location& where, const Schema& schema,
                               const std::optional<SubstanceUnits>& units, Diagnostics& diagnostics);

/// Give options the values of a table. Absent keys, and those whose values were found missing or wrong, leave them as
/// they are. @pre the table was validated by a schema with the keys of the description
void take(Description& description, const Section& section);

/// Report what is wrong with the values of a table, as pairs of key and message, at their places; without a key it is
/// the table. Values that were found wrong before are left out.
/// @throws ContractViolation for a key that the table cannot have
void report_at_keys(const std::vector<std::pair<std::string, std::string>>& mistakes, const Section& section,
                    Diagnostics& diagnostics);

/// A plug-in with the options of a table. @pre as take()
template <class Plugin>
[[nodiscard]] auto choose(const Plugin& plugin, const Section& section) {
    return choose(plugin, [&section](Description& description) { take(description, section); });
}

}  // namespace ljmd
