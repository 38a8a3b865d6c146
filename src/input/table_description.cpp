#include "ljmd/input/table_description.hpp"

#include <algorithm>

#include "ljmd/core/errors.hpp"

namespace ljmd {

Key& TableDescription::add_other(const Key& key, const void* member, Reader reader) {
    others_.push_back(key.name);
    readers_.push_back(std::move(reader));
    return add(key, Other{member});
}

Schema::Selection& TableDescription::selection(const std::string& selector) {
    const auto found = std::ranges::find(selections_, selector, &Schema::Selection::key);
    return found != selections_.end() ? *found : selections_.emplace_back(Schema::Selection{selector, {}});
}

void TableDescription::when(const std::string& selector, const std::string& choice, const Description& keys) {
    selection(selector).cases[choice] = keys.keys();
    cases_.push_back({selector, choice, keys});
}

Schema TableDescription::schema(const std::string& title) const {
    Schema schema(title, keys());
    for (const Schema::Selection& selection : selections_) {
        schema.select(selection.key, selection.cases);
    }
    return schema;
}

const std::string& TableDescription::key_of(const void* member) const {
    const std::string* found = Description::key_of(member);
    for (auto one = cases_.begin(); found == nullptr && one != cases_.end(); ++one) {
        found = one->keys.key_of(member);
    }
    if (found == nullptr) {
        throw ContractViolation("a member that no key of the table is bound to");
    }
    return *found;
}

namespace {

/// Set members that are plain values. A table of another choice lacks the keys of this one.
void take_plain(Description& description, const std::vector<std::string>& others, const Section& section) {
    for (const Key& key : description.keys()) {
        if (section.has(key.name) && std::ranges::find(others, key.name) == others.end()) {
            description.take(key.name, section.plain(key.name));
        }
    }
}

}  // namespace

void TableDescription::read(const Section& section) {
    take_plain(*this, others_, section);
    for (const Reader& reader : readers_) {
        reader(section);
    }
    for (Case& one : cases_) {
        if (section.plain(one.selector) == PlainValue(one.choice)) {
            take_plain(one.keys, {}, section);
        }
    }
}

}  // namespace ljmd
