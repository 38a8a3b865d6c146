#include "ljmd/detail/options/schema.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"

namespace ljmd {

Key::Key(std::string key_name, Kind key_kind) : name(std::move(key_name)), kind(key_kind) {}

Key Key::flag(std::string key_name) {
    return {std::move(key_name), Kind::flag};
}

Key Key::integer(std::string key_name) {
    return {std::move(key_name), Kind::integer};
}

Key Key::number(std::string key_name) {
    return {std::move(key_name), Kind::number};
}

Key Key::text(std::string key_name) {
    return {std::move(key_name), Kind::text};
}

Key Key::choice(std::string key_name, std::vector<std::string> names) {
    if (names.empty()) throw ContractViolation("Key::choice: '" + key_name + "' has no choices");
    Key key(std::move(key_name), Kind::choice);
    key.choices = std::move(names);
    return key;
}

Key Key::quantity(std::string key_name, Dimension what) {
    Key key(std::move(key_name), Kind::quantity);
    key.physical_dimension = what;
    return key;
}

Key Key::interval(std::string key_name) {
    return {std::move(key_name), Kind::interval};
}

Key Key::vector(std::string key_name) {
    return {std::move(key_name), Kind::vector};
}

Key Key::table(std::string key_name, Schema schema) {
    Key key(std::move(key_name), Kind::table);
    key.inner.push_back(std::move(schema));
    return key;
}

Key Key::tables(std::string key_name, Schema schema) {
    Key key(std::move(key_name), Kind::tables);
    key.inner.push_back(std::move(schema));
    return key;
}

Key& Key::meaning(std::string words) {
    meaning_text = std::move(words);
    return *this;
}

Key& Key::unit(std::string unit_name) {
    reduced_unit = std::move(unit_name);
    return *this;
}

Key& Key::dimension(Dimension what) {
    physical_dimension = what;
    return *this;
}

Key& Key::at_least(double bound) {
    low = bound;
    low_open = false;
    return *this;
}

Key& Key::above(double bound) {
    low = bound;
    low_open = true;
    return *this;
}

Key& Key::at_most(double bound) {
    high = bound;
    high_open = false;
    return *this;
}

Key& Key::below(double bound) {
    high = bound;
    high_open = true;
    return *this;
}

Key& Key::components(Index least, Index most) {
    if (least < 1 || most < least) throw ContractViolation("Key::components: '" + name + "' allows no array");
    min_components = least;
    max_components = most;
    return *this;
}

Key& Key::optional(std::string when_absent) {
    required = false;
    absent_text = std::move(when_absent);
    return *this;
}

Key& Key::defaults_to(PlainValue value) {
    if (const auto* integer_value = std::get_if<std::int64_t>(&value); integer_value && kind == Kind::number) {
        value = static_cast<double>(*integer_value);
    }
    const auto* text = std::get_if<std::string>(&value);
    const bool fits = (kind == Kind::flag && std::holds_alternative<bool>(value)) ||
                      (kind == Kind::integer && std::holds_alternative<std::int64_t>(value)) ||
                      (kind == Kind::number && std::holds_alternative<double>(value)) ||
                      (kind == Kind::interval &&
                       (std::holds_alternative<std::int64_t>(value) || (text != nullptr && parse_wall_time(*text)))) ||
                      (kind == Kind::vector && std::holds_alternative<std::vector<double>>(value)) ||
                      ((kind == Kind::text || kind == Kind::choice) && std::holds_alternative<std::string>(value));
    if (!fits) throw ContractViolation("Key::defaults_to: the default of '" + name + "' has another type");
    required = false;
    default_value = std::move(value);
    return *this;
}

Key& Key::step_interval() {
    if (kind != Kind::integer) throw ContractViolation("Key::step_interval: '" + name + "' is no integer");
    is_step_interval = true;
    return *this;
}

std::string Key::type() const {
    switch (kind) {
        case Kind::flag:
            return "boolean";
        case Kind::integer:
            return "integer";
        case Kind::number:
            return "number";
        case Kind::text:
        case Kind::choice:
            return "string";
        case Kind::quantity:
            return "number with a unit, in quotes";
        case Kind::interval:
            return "integer, or wall time in quotes";
        case Kind::vector:
            return fmt::format("array of {} number{}", allowed_components(), max_components == 1 ? "" : "s");
        case Kind::table:
            return "table";
        case Kind::tables:
            break;
    }
    return "array of tables";
}

std::string Key::allowed_components() const {
    if (min_components == max_components) return fmt::format("{}", min_components);
    return fmt::format("{} to {}", min_components, max_components);
}

std::string Key::allowed() const {
    if (kind == Kind::choice) return fmt::format("one of '{}'", fmt::join(choices, "', '"));
    std::string text;
    if (std::isfinite(low)) text = fmt::format("{} {}", low_open ? ">" : ">=", low);
    if (std::isfinite(high)) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", high_open ? "<" : "<=", high);
    if (kind == Kind::interval) {
        return fmt::format("{}{}steps, or a number > 0 with s, min, h or d, in quotes", text, text.empty() ? "" : " ");
    }
    return kind == Kind::vector && !text.empty() ? "each " + text : text;
}

Schema::Schema(std::string title, const std::vector<Key>& keys) : title_(std::move(title)) {
    *this = with(keys);
}

Schema Schema::with(const std::vector<Key>& more) const {
    Schema extended = *this;
    for (const Key& key : more) {
        if (extended.find(key.name)) throw ContractViolation("Schema " + title_ + " has two keys '" + key.name + "'");
        extended.keys_.push_back(key);
    }
    return extended;
}

Schema& Schema::select(const std::string& key, std::map<std::string, std::vector<Key>> cases) {
    const Key* selector = find(key);
    if (!selector || selector->kind != Kind::choice) {
        throw ContractViolation("Schema " + title_ + " cannot select by '" + key + "'");
    }
    selections_.push_back({key, std::move(cases)});
    return *this;
}

Schema Schema::resolved_for(const Table& table) const {
    Schema resolved = *this;
    for (const Selection& selection : selections_) {
        const Entry* entry = ljmd::find(table, selection.key);
        const auto* chosen = entry ? std::get_if<std::string>(&entry->value.data) : nullptr;
        const Key* selector = find(selection.key);
        if (!entry && selector->default_value) chosen = std::get_if<std::string>(&*selector->default_value);
        if (chosen && selection.cases.contains(*chosen)) resolved = resolved.with(selection.cases.at(*chosen));
    }
    return resolved;
}

const Key* Schema::find(const std::string& name) const {
    for (const Key& key : keys_) {
        if (key.name == name) return &key;
    }
    return nullptr;
}

}  // namespace ljmd
