#include "options/key_paths.hpp"

#include <algorithm>
#include <iterator>

#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

namespace {

constexpr std::size_t most_places = 3;

void add_places(const Schema& schema, const std::string& before, std::vector<KeyPlace>& places);

void add_place(const Key& key, const std::string& table, const std::string& before, std::vector<KeyPlace>& places) {
    const std::string path = before + key.name;
    // Several choices of a plug-in may have a key of one name.
    if (std::ranges::find(places, path, &KeyPlace::path) == places.end()) {
        places.push_back({path, key.name, table, !key.inner.empty()});
    }
    if (!key.inner.empty()) {
        const Schema& inner = key.inner.front();
        const char* element = key.kind != Kind::tables ? "." : inner.find("name") != nullptr ? ".NAME." : ".NUMBER.";
        add_places(inner, path + element, places);
    }
}

void add_places(const Schema& schema, const std::string& before, std::vector<KeyPlace>& places) {
    for (const Key& key : schema.keys()) {
        add_place(key, schema.title(), before, places);
    }
    for (const auto& selection : schema.selections()) {
        for (const auto& [choice, keys] : selection.cases) {
            for (const Key& key : keys) {
                add_place(key, schema.title(), before, places);
            }
        }
    }
}

bool is_inner(const KeyPlace& place) {
    return place.path != place.name;
}

}  // namespace

std::vector<KeyPlace> key_places(const Schema& schema) {
    std::vector<KeyPlace> places;
    add_places(schema, "", places);
    return places;
}

std::vector<KeyPlace> inner_places(const Schema& schema, const std::string& name) {
    std::vector<KeyPlace> places = key_places(schema);
    std::erase_if(places, [&](const KeyPlace& place) { return !is_inner(place) || place.name != name; });
    return places.size() > most_places ? std::vector<KeyPlace>{} : places;
}

std::string nearest_inner_name(const Schema& schema, const std::string& name) {
    std::vector<std::string> names;
    for (const KeyPlace& place : key_places(schema)) {
        if (is_inner(place)) {
            names.push_back(place.name);
        }
    }
    return nearest_name(name, names);
}

}  // namespace ljmd
