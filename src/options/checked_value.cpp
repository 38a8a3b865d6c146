#include "options/checked_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/text.hpp"
#include "options/words_elsewhere.hpp"

namespace ljmd {
namespace {

bool reads_as(Kind kind, const std::string& text) {
    if (kind == Kind::flag) return text == "true" || text == "false";
    if (kind == Kind::number) return unit_of(text) == std::string{};
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return kind == Kind::integer && error == std::errc{} && end == text.data() + text.size();
}

bool in_range(const Key& key, double value) {
    return (key.low_open ? value > key.low : value >= key.low) &&
           (key.high_open ? value < key.high : value <= key.high);
}

/// The first of a few simple numbers that a key allows.
double plain_number(const Key& key) {
    for (const double candidate : {1.0, key.low, key.high, 0.5 * (key.low + key.high), key.low + 1.0, key.high - 1.0}) {
        if (std::isfinite(candidate) && in_range(key, candidate)) return candidate;
    }
    return 0.0;
}

}  // namespace

std::string KeyContext::subject() const {
    const std::string whole = fmt::format("'{}' in {}", key.name, title);
    return component == 0 ? whole : fmt::format("component {} of {}", component, whole);
}

std::string expected_kind(const Key& key) {
    if (key.kind == Kind::flag) return "true or false";
    const std::string type = key.type();
    return (type.starts_with('a') || type.starts_with('i') ? "an " : "a ") + type;
}

bool is_table_kind(Kind kind) {
    return kind == Kind::table || kind == Kind::tables;
}

std::string allowed_hint(const Key& key) {
    if (key.kind == Kind::quantity) return "allowed: " + unit_names(key.physical_dimension);
    if (is_table_kind(key.kind)) {
        const std::string& title = key.inner.front().title();
        return title.starts_with('[') ? "write " + title : "";
    }
    const std::string allowed = key.allowed();
    return allowed.empty() || key.kind == Kind::choice ? allowed : "allowed: " + allowed;
}

/// How a table is written where its type, or a single value, stands in its place.
std::string table_hint(const Key& key, const std::string* text) {
    const Schema& table = key.inner.front();
    const auto& selections = table.selections();
    if (text != nullptr && !selections.empty() && selections.front().cases.contains(*text)) {
        return fmt::format("write {{ {} = \"{}\" }}", selections.front().key, *text);
    }
    const std::string hint = allowed_hint(key);
    const bool all_optional = std::ranges::none_of(table.keys(), [](const Key& inner) { return inner.required; });
    return hint.empty() && all_optional ? "write {} for all defaults" : hint;
}

void report_wrong_kind(const KeyContext& context, const Value& value) {
    const Key& key = context.key;
    std::string hint = allowed_hint(key);
    const auto* text = std::get_if<std::string>(&value.data);
    if (text && reads_as(key.kind, *text)) hint = "remove the quotes";
    const bool has_parts = std::holds_alternative<Array>(value.data) || std::holds_alternative<Table>(value.data);
    if (key.kind == Kind::text && !has_parts) hint = "put it in quotes";
    if (key.kind == Kind::table && !has_parts) hint = table_hint(key, text);
    context.diagnostics.error(
        value.location, fmt::format("{} must be {}, found {}", context.subject(), expected_kind(key), kind_name(value)),
        hint);
}

PlainValue fallback_value(const Key& key) {
    if (key.default_value) return *key.default_value;
    switch (key.kind) {
        case Kind::flag:
            return false;
        case Kind::integer:
        case Kind::interval:
            return static_cast<std::int64_t>(plain_number(key));
        case Kind::number:
        case Kind::quantity:
            return plain_number(key);
        case Kind::choice:
            return key.choices.front();
        case Kind::vector:
            return std::vector<double>(static_cast<std::size_t>(key.min_components), plain_number(key));
        default:
            return std::string{};
    }
}

namespace {

/// Stand-in for a number out of range: the bound that it crossed if that is allowed, else the fallback.
PlainValue nearest_allowed(const Key& key, double value) {
    if (std::isnan(value)) return fallback_value(key);
    const double bound = value < key.low ? key.low : key.high;
    if (!std::isfinite(bound) || !in_range(key, bound)) return fallback_value(key);
    if (key.kind == Kind::integer || key.kind == Kind::interval) return static_cast<std::int64_t>(bound);
    return bound;
}

/// Check the range of a number that was written as `found`. @return the number (-0 as +0), or a stand-in
PlainValue checked_number(const KeyContext& context, const Value& value, double number, const std::string& found) {
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

/// A number with a unit, for Kind::number, in reduced units.
PlainValue number_with_unit(const KeyContext& context, const Value& value, const std::string& text) {
    const Dimension dimension = context.key.physical_dimension;
    const auto unit = unit_of(text);
    if (!unit || unit->empty()) {
        report_wrong_kind(context, value);
    } else if (dimension == Dimension::none) {
        context.diagnostics.error(value.location,
                                  fmt::format("{} takes no unit, found {}", context.subject(), in_quotes(text)));
    } else if (const auto si = parse_quantity(text, dimension); !si) {
        context.diagnostics.error(
            value.location, fmt::format("{}: {} is no unit of {}, allowed: {}", context.subject(), in_quotes(*unit),
                                        dimension_name(dimension), unit_names(dimension)));
    } else if (!context.units) {
        context.diagnostics.error(
            value.location, fmt::format("{}: unit {} needs an [argon] table", context.subject(), in_quotes(*unit)));
    } else {
        const double reduced = context.units->reduced(*si, dimension);
        return checked_number(context, value, reduced,
                              fmt::format("{} ({:.6g} in reduced units)", in_quotes(text), reduced));
    }
    return fallback_value(context.key);
}

/// A number with a unit, for Kind::quantity, in SI.
PlainValue quantity(const KeyContext& context, const Value& value, const std::string& text) {
    const Dimension dimension = context.key.physical_dimension;
    if (const auto si = parse_quantity(text, dimension)) return checked_number(context, value, *si, in_quotes(text));
    const auto unit = unit_of(text);
    const std::string mistake =
        !unit || unit->empty()
            ? fmt::format("{} must be a number with a unit, found {}", context.subject(), in_quotes(text))
            : fmt::format("{}: {} is no unit of {}", context.subject(), in_quotes(*unit), dimension_name(dimension));
    context.diagnostics.error(value.location, mistake, allowed_hint(context.key));
    return fallback_value(context.key);
}

PlainValue choice(const KeyContext& context, const Value& value, const std::string& text) {
    const auto& choices = context.key.choices;
    if (std::find(choices.begin(), choices.end(), text) != choices.end()) return text;
    const std::string nearest = nearest_name(text, choices);
    const std::string elsewhere = word_elsewhere(text);
    const std::string similar = nearest.empty() ? "" : "did you mean '" + nearest + "'?";
    context.diagnostics.error(
        value.location, fmt::format("{} is {}, allowed: {}", context.subject(), in_quotes(text), context.key.allowed()),
        elsewhere.empty() ? similar : elsewhere);
    return nearest.empty() ? fallback_value(context.key) : PlainValue(nearest);
}

/// A wall time for Kind::interval, as written.
PlainValue wall_time(const KeyContext& context, const Value& value, const std::string& text) {
    if (parse_wall_time(text)) return text;
    context.diagnostics.error(value.location, fmt::format("{}: {} is no wall time", context.subject(), in_quotes(text)),
                              allowed_hint(context.key));
    return fallback_value(context.key);
}

PlainValue integer(const KeyContext& context, const Value& value, std::int64_t number) {
    if (in_range(context.key, static_cast<double>(number))) return number;
    return checked_number(context, value, static_cast<double>(number), std::to_string(number));
}

/// The numbers of an array. An array of a wrong length is cut, or filled up with numbers that the key allows.
PlainValue vector(const KeyContext& context, const Value& value, const Array& array) {
    const Key& key = context.key;
    const auto count = static_cast<Index>(array.size());
    if (count < key.min_components || count > key.max_components) {
        context.diagnostics.error(value.location, fmt::format("{} has {} component{}, allowed: {}", context.subject(),
                                                              count, count == 1 ? "" : "s", key.allowed_components()));
    }
    Key one = key;
    one.kind = Kind::number;
    one.default_value.reset();
    std::vector<double> numbers;
    for (const Value& element : array) {
        const auto component = static_cast<Index>(numbers.size()) + 1;
        numbers.push_back(std::get<double>(
            checked_value({one, context.title, context.units, context.diagnostics, component}, element)));
    }
    const Index allowed_count = std::clamp(count, key.min_components, key.max_components);
    numbers.resize(static_cast<std::size_t>(allowed_count), plain_number(key));
    return numbers;
}

}  // namespace

PlainValue checked_value(const KeyContext& context, const Value& value) {
    const Kind kind = context.key.kind;
    if (const auto* flag = std::get_if<bool>(&value.data); flag && kind == Kind::flag) return *flag;
    if (const auto* number = std::get_if<std::int64_t>(&value.data)) {
        if (kind == Kind::integer || kind == Kind::interval) return integer(context, value, *number);
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
        if (kind == Kind::interval) return wall_time(context, value, *text);
    }
    if (const auto* array = std::get_if<Array>(&value.data); array && kind == Kind::vector) {
        return vector(context, value, *array);
    }
    report_wrong_kind(context, value);
    return fallback_value(context.key);
}

}  // namespace ljmd
