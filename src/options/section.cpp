#include "ljmd/detail/options/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/text.hpp"
#include "ljmd/core/errors.hpp"
#include "options/checked_value.hpp"
#include "options/key_paths.hpp"
#include "options/words_elsewhere.hpp"

namespace ljmd {
namespace {

bool is_table(const Value& value) {
    const auto* array = std::get_if<Array>(&value.data);
    return array && !array->empty() ? is_table(array->front()) : std::holds_alternative<Table>(value.data);
}

/// The tables in a key of Kind::table (one) or Kind::tables (any number). Mistakes are reported and left out.
std::vector<const Value*> tables_of(const KeyContext& context, const Value& value) {
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

void report_missing(const KeyContext& context, const Location& where) {
    const Kind kind = context.key.kind;
    // The type says more here than the range of the components; what a quantity means has an example.
    const bool has_example = kind == Kind::quantity && !context.key.meaning_text.empty();
    const std::string hint = kind == Kind::vector ? ""
                             : has_example        ? context.key.meaning_text
                                                  : allowed_hint(context.key);
    context.diagnostics.error(
        where,
        fmt::format("missing {} '{}' in {}", is_table_kind(kind) ? "table" : "key", context.key.name, context.title),
        hint.empty() ? expected_kind(context.key) : hint);
}

struct Owner {
    std::string selector;  ///< key that makes the choice
    std::string choices;   ///< for messages: `type = 'mie' or 'morse'`
};

/// The choices that have a key of this name; nothing if none has.
std::optional<Owner> choices_with_key(const Schema& schema, const std::string& name) {
    for (const auto& selection : schema.selections()) {
        std::vector<std::string> owners;
        for (const auto& [choice, keys] : selection.cases) {
            const bool owns = std::any_of(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
            if (owns) owners.push_back("'" + choice + "'");
        }
        if (!owners.empty()) {
            return Owner{selection.key, fmt::format("{} = {}", selection.key, fmt::join(owners, " or "))};
        }
    }
    return std::nullopt;
}

/// Whether a table makes a valid choice for a key. If not, the additional keys that belong to it are unknown.
bool makes_choice(const Table& table, const Key& selector) {
    const Entry* entry = find(table, selector.name);
    const auto* chosen = entry ? std::get_if<std::string>(&entry->value.data) : nullptr;
    return entry ? chosen &&
                       std::find(selector.choices.begin(), selector.choices.end(), *chosen) != selector.choices.end()
                 : selector.default_value.has_value();
}

/// The places of a key that was looked for in the wrong table: as a path for `--set`, which has no line; else by table.
std::string places_in_words(const std::vector<KeyPlace>& places, const Location& where) {
    std::vector<std::string> words;
    words.reserve(places.size());
    for (const KeyPlace& place : places) {
        words.push_back(where.line == 0 ? fmt::format("'{}'", place.path)
                                        : fmt::format("'{}' in {}", place.name, place.table));
    }
    return fmt::format("did you mean {}?", fmt::join(words, " or "));
}

/// What an unknown key was probably meant to be. @param nearest  the known key of the table that is most like it
std::string hint_for(const Entry& entry, const Schema& schema, const std::vector<std::string>& known,
                     const std::string& nearest) {
    if (const auto places = inner_places(schema, entry.key); !places.empty()) {
        return places_in_words(places, entry.key_location);
    }
    if (const std::string hint = word_elsewhere(entry.key); !hint.empty()) {
        return hint;
    }
    if (!nearest.empty()) {
        return fmt::format("did you mean '{}'?", nearest);
    }
    if (const auto places = inner_places(schema, nearest_inner_name(schema, entry.key)); !places.empty()) {
        return places_in_words(places, entry.key_location);
    }
    return known.empty() ? "no keys are known here" : fmt::format("known keys: {}", fmt::join(known, ", "));
}

/// @return known keys that unknown ones were probably meant to be
std::set<std::string> report_unknown(const Table& table, const Schema& schema, Diagnostics& diagnostics) {
    std::set<std::string> meant;
    std::vector<std::string> known;
    std::vector<std::pair<const Entry*, Owner>> misplaced;
    for (const Key& key : schema.keys()) known.push_back(key.name);
    for (const Entry& entry : table) {
        if (schema.find(entry.key)) continue;
        if (const auto owner = choices_with_key(schema, entry.key)) {
            misplaced.emplace_back(&entry, *owner);
            continue;
        }
        const std::string nearest = nearest_name(entry.key, known);
        meant.insert(nearest);
        diagnostics.error(entry.key_location,
                          fmt::format("unknown {} {} in {}", is_table(entry.value) ? "table" : "key",
                                      in_quotes(entry.key), schema.title()),
                          hint_for(entry, schema, known, nearest));
    }
    for (const auto& [entry, owner] : misplaced) {
        if (meant.contains(owner.selector) || !makes_choice(table, *schema.find(owner.selector))) continue;
        diagnostics.error(entry->key_location, fmt::format("key {} in {} goes only with {}", in_quotes(entry->key),
                                                           schema.title(), owner.choices));
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

const PlainValue& Section::plain(const std::string& key) const {
    const auto found = items_.find(key);
    if (found == items_.end() || !found->second.value) {
        throw ContractViolation("Section " + title_ + " has no value of key '" + key + "'");
    }
    return *found->second.value;
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

bool Section::knows(const std::string& key) const {
    return items_.contains(key);
}

bool Section::sound(const std::string& key) const {
    const auto found = items_.find(key);
    return found == items_.end() || found->second.sound;
}

bool Section::all_sound() const {
    return std::ranges::all_of(items_, [](const auto& entry) { return entry.second.sound; });
}

bool Section::written(const std::string& key) const {
    // A default value has the location of its table.
    const Location value = location(key);
    return has(key) && std::tie(value.source, value.line, value.column) !=
                           std::tie(location_.source, location_.line, location_.column);
}

std::optional<StepInterval> Section::step_interval() const {
    for (const auto& [key, item] : items_) {
        if (item.is_step_interval && item.present) {
            return StepInterval{std::get<std::int64_t>(*item.value), item.location};
        }
    }
    return std::nullopt;
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
        const KeyContext context{key, schema.title(), units, diagnostics};
        const Entry* entry = find(table, key.name);
        if (!entry && key.required && !meant.contains(key.name)) report_missing(context, where);
        Section::Item item{key.kind, {}, {}, entry ? entry->value.location : where, false, true, key.is_step_interval};
        item.present = entry || key.required || key.default_value;
        item.sound = entry || !(key.required || meant.contains(key.name));
        if (!is_table_kind(key.kind)) {
            const std::size_t mistakes = diagnostics.entries().size();
            if (item.present) item.value = entry ? checked_value(context, entry->value) : fallback_value(key);
            item.sound = item.sound && diagnostics.entries().size() == mistakes;
        } else if (entry) {
            for (const Value* inner : tables_of(context, entry->value)) {
                item.sections.push_back(
                    validate(std::get<Table>(inner->data), inner->location, key.inner.front(), units, diagnostics));
            }
        }
        if (is_table_kind(key.kind) && item.present && item.sections.empty()) item.sound = false;
        if (key.kind == Kind::table && item.present && item.sections.empty()) {
            Diagnostics unheard;  // discarded: the mistake is the missing table, not each of its keys
            item.sections.push_back(validate({}, item.location, key.inner.front(), units, unheard));
        }
        section.items_.emplace(key.name, std::move(item));
    }
    return section;
}

void take(Description& description, const Section& section) {
    for (const Key& key : description.keys()) {
        if (section.has(key.name) && section.sound(key.name)) {
            description.take(key.name, section.plain(key.name));
        }
    }
}

void report_at_keys(const std::vector<std::pair<std::string, std::string>>& mistakes, const Section& section,
                    Diagnostics& diagnostics) {
    for (const auto& [key, message] : mistakes) {
        if (!key.empty() && !section.knows(key))
            throw ContractViolation("Section " + section.title() + " has no key '" + key + "'");
        if (section.sound(key)) diagnostics.error(section.location(key), message);
    }
}

}  // namespace ljmd
