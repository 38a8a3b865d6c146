#include "ljmd/core/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"

namespace ljmd {
namespace {

using Scalar = std::variant<bool, std::int64_t, double, std::string>;

constexpr std::size_t max_quoted = 60;

/// What the checks of one key need.
struct Context {
    const Key& key;
    const std::string& title;
    const std::optional<SubstanceUnits>& units;
    Diagnostics& diagnostics;

    [[nodiscard]] std::string subject() const { return fmt::format("'{}' in {}", key.name, title); }
};

std::string quoted(const std::string& text) {
    return "'" + printable(text, max_quoted) + "'";
}

std::string expected(Kind kind) {
    switch (kind) {
        case Kind::flag:
            return "true or false";
        case Kind::integer:
            return "an integer";
        case Kind::number:
            return "a number";
        case Kind::text:
        case Kind::choice:
            return "a string";
        case Kind::quantity:
            return "a number with a unit, in quotes";
        case Kind::table:
            return "a table";
        case Kind::tables:
            break;
    }
    return "an array of tables";
}

bool is_table_kind(Kind kind) {
    return kind == Kind::table || kind == Kind::tables;
}

bool is_table(const Value& value) {
    const auto* array = std::get_if<Array>(&value.data);
    return array && !array->empty() ? is_table(array->front()) : std::holds_alternative<Table>(value.data);
}

/// The range, the choices, the units or the header of a key as a hint; empty when anything goes.
std::string allowed_hint(const Key& key) {
    if (key.kind == Kind::quantity) return "allowed: " + unit_names(key.physical_dimension);
    if (is_table_kind(key.kind)) {
        const std::string& title = key.inner.front().title();
        return title.starts_with('[') ? "write " + title : "";
    }
    const std::string allowed = key.allowed();
    return allowed.empty() || key.kind == Kind::choice ? allowed : "allowed: " + allowed;
}

bool reads_as(Kind kind, const std::string& text) {
    if (kind == Kind::flag) return text == "true" || text == "false";
    if (kind == Kind::number) return unit_of(text) == std::string{};
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return kind == Kind::integer && error == std::errc{} && end == text.data() + text.size();
}

void report_wrong_kind(const Context& context, const Value& value) {
    const Key& key = context.key;
    std::string hint = allowed_hint(key);
    const auto* text = std::get_if<std::string>(&value.data);
    if (text && reads_as(key.kind, *text)) hint = "remove the quotes";
    const bool has_parts = std::holds_alternative<Array>(value.data) || std::holds_alternative<Table>(value.data);
    if (key.kind == Kind::text && !has_parts) hint = "put it in quotes";
    context.diagnostics.error(
        value.location, fmt::format("{} must be {}, found {}", context.subject(), expected(key.kind), kind_name(value)),
        hint);
}

bool in_range(const Key& key, double value) {
    return (key.low_open ? value > key.low : value >= key.low) &&
           (key.high_open ? value < key.high : value <= key.high);
}

/// A value that a key allows: its default, or the first allowed one of a few plain ones.
double plain_number(const Key& key) {
    for (const double candidate : {1.0, key.low, key.high, 0.5 * (key.low + key.high), key.low + 1.0, key.high - 1.0}) {
        if (std::isfinite(candidate) && in_range(key, candidate)) return candidate;
    }
    return 0.0;
}

Scalar fallback(const Key& key) {
    if (key.default_value) return *key.default_value;
    switch (key.kind) {
        case Kind::flag:
            return false;
        case Kind::integer:
            return static_cast<std::int64_t>(plain_number(key));
        case Kind::number:
        case Kind::quantity:
            return plain_number(key);
        case Kind::choice:
            return key.choices.front();
        default:
            return std::string{};
    }
}

/// Stand-in for a number outside its range: the bound that it has crossed if that is allowed, else the fallback.
Scalar nearest_allowed(const Key& key, double value) {
    if (std::isnan(value)) return fallback(key);
    const double bound = value < key.low ? key.low : key.high;
    if (!std::isfinite(bound) || !in_range(key, bound)) return fallback(key);
    if (key.kind == Kind::integer) return static_cast<std::int64_t>(bound);
    return bound;
}

/// Range check of a number that was written as `found`. @return the number (-0 as +0), or a stand-in
Scalar checked_number(const Context& context, const Value& value, double number, const std::string& found) {
    if (!std::isfinite(number)) {
        context.diagnostics.error(value.location, fmt::format("{} must be finite, found {}", context.subject(), found),
                                  allowed_hint(context.key));
    } else if (!in_range(context.key, number)) {
        context.diagnostics.error(
            value.location, fmt::format("{} is {}, allowed: {}", context.subject(), found, context.key.allowed()));
    } else {
        return number + 0.0;
    }
    return nearest_allowed(context.key, number);
}

/// A number with a unit for a key of Kind::number, in reduced units.
Scalar number_with_unit(const Context& context, const Value& value, const std::string& text) {
    const Dimension dimension = context.key.physical_dimension;
    const auto unit = unit_of(text);
    if (!unit || unit->empty()) {
        report_wrong_kind(context, value);
    } else if (dimension == Dimension::none) {
        context.diagnostics.error(value.location,
                                  fmt::format("{} takes no unit, found {}", context.subject(), quoted(text)));
    } else if (const auto si = parse_quantity(text, dimension); !si) {
        context.diagnostics.error(value.location,
                                  fmt::format("{}: {} is no unit of {}, allowed: {}", context.subject(), quoted(*unit),
                                              dimension_name(dimension), unit_names(dimension)));
    } else if (!context.units) {
        context.diagnostics.error(value.location,
                                  fmt::format("{}: unit {} needs an [argon] table", context.subject(), quoted(*unit)));
    } else {
        const double reduced = context.units->reduced(*si, dimension);
        return checked_number(context, value, reduced,
                              fmt::format("{} ({:.6g} in reduced units)", quoted(text), reduced));
    }
    return fallback(context.key);
}

/// A number with a unit for a key of Kind::quantity, in SI.
Scalar quantity(const Context& context, const Value& value, const std::string& text) {
    const Dimension dimension = context.key.physical_dimension;
    if (const auto si = parse_quantity(text, dimension)) return checked_number(context, value, *si, quoted(text));
    const auto unit = unit_of(text);
    const std::string mistake =
        !unit || unit->empty()
            ? fmt::format("{} must be a number with a unit, found {}", context.subject(), quoted(text))
            : fmt::format("{}: {} is no unit of {}", context.subject(), quoted(*unit), dimension_name(dimension));
    context.diagnostics.error(value.location, mistake, allowed_hint(context.key));
    return fallback(context.key);
}

Scalar choice(const Context& context, const Value& value, const std::string& text) {
    const auto& choices = context.key.choices;
    if (std::find(choices.begin(), choices.end(), text) != choices.end()) return text;
    const std::string nearest = nearest_name(text, choices);
    context.diagnostics.error(
        value.location, fmt::format("{} is {}, allowed: {}", context.subject(), quoted(text), context.key.allowed()),
        nearest.empty() ? "" : "did you mean '" + nearest + "'?");
    return nearest.empty() ? fallback(context.key) : Scalar(nearest);
}

Scalar integer(const Context& context, const Value& value, std::int64_t number) {
    if (in_range(context.key, static_cast<double>(number))) return number;
    return checked_number(context, value, static_cast<double>(number), std::to_string(number));
}

/// The value of a key that is no table. Every mistake is reported; what returns is always of the key's type and range.
Scalar read_scalar(const Context& context, const Value& value) {
    const Kind kind = context.key.kind;
    if (const auto* flag = std::get_if<bool>(&value.data); flag && kind == Kind::flag) return *flag;
    if (const auto* number = std::get_if<std::int64_t>(&value.data)) {
        if (kind == Kind::integer) return integer(context, value, *number);
        if (kind == Kind::number) {
            return checked_number(context, value, static_cast<double>(*number), std::to_string(*number));
        }
    }
    if (const auto* number = std::get_if<double>(&value.data); number && kind == Kind::number) {
        return checked_number(context, value, *number, fmt::format("{}", *number));
    }
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        if (kind == Kind::text) return *text;
        if (kind == Kind::choice) return choice(context, value, *text);
        if (kind == Kind::number) return number_with_unit(context, value, *text);
        if (kind == Kind::quantity) return quantity(context, value, *text);
    }
    report_wrong_kind(context, value);
    return fallback(context.key);
}

/// The tables that a key of Kind::table (one) or Kind::tables (any number) holds; a mistake is reported and left out.
std::vector<const Value*> tables_of(const Context& context, const Value& value) {
    if (context.key.kind == Kind::table) {
        if (std::holds_alternative<Table>(value.data)) return {&value};
        report_wrong_kind(context, value);
        return {};
    }
    const auto* array = std::get_if<Array>(&value.data);
    if (!array) {
        report_wrong_kind(context, value);
        return {};
    }
    if (array->empty() && context.key.required) {
        context.diagnostics.error(value.location, context.subject() + " is empty", allowed_hint(context.key));
    }
    std::vector<const Value*> tables;
    for (const Value& element : *array) {
        if (std::holds_alternative<Table>(element.data)) {
            tables.push_back(&element);
        } else {
            report_wrong_kind(context, element);
        }
    }
    return tables;
}

void report_missing(const Context& context, const Location& where) {
    const Kind kind = context.key.kind;
    const std::string hint = allowed_hint(context.key);
    context.diagnostics.error(
        where,
        fmt::format("missing {} '{}' in {}", is_table_kind(kind) ? "table" : "key", context.key.name, context.title),
        hint.empty() ? expected(kind) : hint);
}

/// The choices that a key belongs to, as `type = 'mie' or 'morse'`; empty when it belongs to none.
std::string choices_with_key(const Schema& schema, const std::string& name) {
    for (const auto& selection : schema.selections()) {
        std::vector<std::string> owners;
        for (const auto& [choice, keys] : selection.cases) {
            const bool owns = std::any_of(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
            if (owns) owners.push_back("'" + choice + "'");
        }
        if (!owners.empty()) return fmt::format("{} = {}", selection.key, fmt::join(owners, " or "));
    }
    return {};
}

/// @return the known keys that the unknown ones were probably meant to be
std::set<std::string> report_unknown(const Table& table, const Schema& schema, Diagnostics& diagnostics) {
    std::set<std::string> meant;
    std::vector<std::string> known;
    for (const Key& key : schema.keys()) known.push_back(key.name);
    for (const Entry& entry : table) {
        if (schema.find(entry.key)) continue;
        if (const std::string owner = choices_with_key(schema, entry.key); !owner.empty()) {
            diagnostics.error(entry.key_location,
                              fmt::format("key {} in {} goes only with {}", quoted(entry.key), schema.title(), owner));
            continue;
        }
        const std::string nearest = nearest_name(entry.key, known);
        std::string hint = "no keys are known here";
        if (!known.empty()) hint = fmt::format("known keys: {}", fmt::join(known, ", "));
        if (!nearest.empty()) hint = "did you mean '" + nearest + "'?";
        meant.insert(nearest);
        diagnostics.error(entry.key_location,
                          fmt::format("unknown {} {} in {}", is_table(entry.value) ? "table" : "key", quoted(entry.key),
                                      schema.title()),
                          hint);
    }
    return meant;
}

}  // namespace

const Section::Item& Section::item(const std::string& key, Kind kind) const {
    const auto found = items_.find(key);
    if (found == items_.end() || found->second.kind != kind) {
        throw ContractViolation("Section " + title_ + " has no key '" + key + "' of that kind");
    }
    if (!found->second.present) throw ContractViolation("Section " + title_ + ": key '" + key + "' is absent");
    return found->second;
}

bool Section::flag(const std::string& key) const {
    return std::get<bool>(*item(key, Kind::flag).scalar);
}

std::int64_t Section::integer(const std::string& key) const {
    return std::get<std::int64_t>(*item(key, Kind::integer).scalar);
}

double Section::number(const std::string& key) const {
    const auto found = items_.find(key);
    const bool is_quantity = found != items_.end() && found->second.kind == Kind::quantity;
    return std::get<double>(*item(key, is_quantity ? Kind::quantity : Kind::number).scalar);
}

const std::string& Section::text(const std::string& key) const {
    const auto found = items_.find(key);
    const bool is_choice = found != items_.end() && found->second.kind == Kind::choice;
    return std::get<std::string>(*item(key, is_choice ? Kind::choice : Kind::text).scalar);
}

const Section& Section::section(const std::string& key) const {
    return item(key, Kind::table).sections.front();
}

const std::vector<Section>& Section::sections(const std::string& key) const {
    return item(key, Kind::tables).sections;
}

bool Section::has(const std::string& key) const {
    const auto found = items_.find(key);
    return found != items_.end() && found->second.present;
}

Location Section::location(const std::string& key) const {
    const auto found = items_.find(key);
    return found == items_.end() ? location_ : found->second.location;
}

Section validate(const Table& table, const Location& where, const Schema& general,
                 const std::optional<SubstanceUnits>& units, Diagnostics& diagnostics) {
    const Schema schema = general.resolved_for(table);
    const std::set<std::string> meant = report_unknown(table, schema, diagnostics);
    Section section;
    section.title_ = schema.title();
    section.location_ = where;
    for (const Key& key : schema.keys()) {
        const Context context{key, schema.title(), units, diagnostics};
        const Entry* entry = find(table, key.name);
        if (!entry && key.required && !meant.contains(key.name)) report_missing(context, where);
        Section::Item item{key.kind, {}, {}, entry ? entry->value.location : where, false};
        item.present = entry || key.required || key.default_value;
        if (!is_table_kind(key.kind)) {
            if (item.present) item.scalar = entry ? read_scalar(context, entry->value) : fallback(key);
        } else if (entry) {
            for (const Value* inner : tables_of(context, entry->value)) {
                item.sections.push_back(
                    validate(std::get<Table>(inner->data), inner->location, key.inner.front(), units, diagnostics));
            }
        }
        if (key.kind == Kind::table && item.present && item.sections.empty()) {
            Diagnostics unheard;  // the table itself is the mistake, not each of its keys
            item.sections.push_back(validate({}, item.location, key.inner.front(), units, unheard));
        }
        section.items_.emplace(key.name, std::move(item));
    }
    return section;
}

}  // namespace ljmd
