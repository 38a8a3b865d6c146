#include "input/json_schema.hpp"

#include <cmath>
#include <map>
#include <set>

#include "io/tables/json_text.hpp"
#include "ljmd/detail/options/units.hpp"

namespace ljmd {

namespace {

Data of_table(const Schema& schema);

Data with_range(Data json, const Key& key) {
    if (std::isfinite(key.low)) {
        json[key.low_open ? "exclusiveMinimum" : "minimum"] = key.low;
    }
    if (std::isfinite(key.high)) {
        json[key.high_open ? "exclusiveMaximum" : "maximum"] = key.high;
    }
    return json;
}

/// The type and range of the value, without its description.
Data of_value(const Key& key) {
    const Data text = {{"type", "string"}};
    switch (key.kind) {
        case Kind::flag:
            return {{"type", "boolean"}};
        case Kind::integer:
            return with_range({{"type", "integer"}}, key);
        case Kind::number:
            if (key.physical_dimension == Dimension::none) {
                return with_range({{"type", "number"}}, key);
            }
            return {{"anyOf", Data::list({with_range({{"type", "number"}}, key), text})}};
        case Kind::text:
        case Kind::quantity:
            return text;
        case Kind::choice:
            return {{"enum", key.choices}};
        case Kind::interval:
            return {{"anyOf", Data::list({with_range({{"type", "integer"}}, key), text})}};
        case Kind::vector:
            return {{"type", "array"},
                    {"items", with_range({{"type", "number"}}, key)},
                    {"minItems", key.min_components},
                    {"maxItems", key.max_components}};
        case Kind::table:
            return of_table(key.inner.front());
        case Kind::tables:
            break;
    }
    return {{"type", "array"}, {"items", of_table(key.inner.front())}};
}

std::string words_about(const Key& key) {
    std::string text = key.meaning_text;
    if (const std::string names = unit_names(key.physical_dimension); !names.empty()) {
        text += (key.reduced_unit.empty() ? " [" : " [" + key.reduced_unit + "; or in quotes ") + names + "]";
    } else if (!key.reduced_unit.empty()) {
        text += " [" + key.reduced_unit + "]";
    }
    if (!key.required && !key.default_value && !key.absent_text.empty()) {
        text += "; without it: " + key.absent_text;
    }
    return text;
}

Data of_key(const Key& key) {
    Data json = {{"description", words_about(key)}};
    json.update(of_value(key));
    if (key.default_value) {
        std::visit([&json](const auto& value) { json["default"] = value; }, *key.default_value);
    }
    return json;
}

void add_required(Data& json, const std::vector<Key>& keys) {
    for (const Key& key : keys) {
        if (key.required) {
            json["required"].push_back(key.name);
        }
    }
}

/// The keys of one choice; other choices' keys are excluded.
Data of_case(const std::vector<Key>& keys, const std::set<std::string>& of_all_cases) {
    Data json = Data::object();
    for (const std::string& name : of_all_cases) {
        json["properties"][name] = false;
    }
    for (const Key& key : keys) {
        json["properties"][key.name] = of_key(key);
    }
    add_required(json, keys);
    return json;
}

/// Add one "if it is this choice, then these keys" for each choice.
void add_selection(Data& json, const Schema& schema, const Schema::Selection& selection) {
    std::set<std::string> names;
    for (const auto& [choice, keys] : selection.cases) {
        for (const Key& key : keys) {
            names.insert(key.name);
        }
    }
    for (const std::string& name : names) {
        json["properties"][name] = true;  // defined by the cases
    }
    const auto& default_value = schema.find(selection.key)->default_value;
    for (const auto& [choice, keys] : selection.cases) {
        Data condition = {{"properties", {{selection.key, {{"const", choice}}}}}};
        if (!default_value || *default_value != PlainValue(choice)) {
            condition["required"] = Data::list({selection.key});
        }
        json["allOf"].push_back({{"if", condition}, {"then", of_case(keys, names)}});
    }
}

Data of_table(const Schema& schema) {
    Data json = {{"type", "object"}, {"properties", Data::object()}};
    for (const Key& key : schema.keys()) {
        json["properties"][key.name] = of_key(key);
    }
    for (const Schema::Selection& selection : schema.selections()) {
        add_selection(json, schema, selection);
    }
    add_required(json, schema.keys());
    json["additionalProperties"] = false;
    return json;
}

}  // namespace

std::string json_schema(const std::string& title, const SchemaChoice& choice) {
    Data marked = Data::list();
    for (const std::string& mark : choice.marks) {
        marked.push_back({{"required", Data::list({mark})}});
    }
    const Data json = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                       {"title", title},
                       {"type", "object"},
                       {"if", {{"anyOf", marked}}},
                       {"then", of_table(choice.marked)},
                       {"else", of_table(choice.usual)}};
    return to_json(json) + "\n";
}

}  // namespace ljmd
