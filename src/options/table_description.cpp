#include "ljmd/detail/options/table_description.hpp"

#include <algorithm>

#include "ljmd/core/errors.hpp"

namespace ljmd {

Key& TableDescription::add_other(const Key& key, const void* member, Reader reader, Writer writer) {
    others_.push_back({key.name, std::move(reader), std::move(writer)});
    return add(key, Description::Other{member});
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
/// @param others  keys of members that are none
template <class Others>
void take_plain(Description& description, const Others& others, const Section& section) {
    for (const Key& key : description.keys()) {
        if (section.has(key.name) &&
            std::ranges::find(others, key.name, [](const auto& o) { return o.key; }) == others.end()) {
            description.take(key.name, section.plain(key.name));
        }
    }
}

}  // namespace

void TableDescription::read(const Section& section) {
    take_plain(*this, others_, section);
    for (const Other& other : others_) {
        other.read(section);
    }
    for (Case& one : cases_) {
        if (section.plain(one.selector) == PlainValue(one.choice)) {
            take_plain(one.keys, std::vector<Other>(), section);
        }
    }
}

Table TableDescription::written() const {
    const Settings plain = values();
    const auto value = [&plain](const std::string& key) {
        return std::ranges::find(plain, key, &std::pair<std::string, PlainValue>::first);
    };
    Table table;
    for (const Key& key : keys()) {
        const auto other = std::ranges::find(others_, key.name, &Other::key);
        if (other != others_.end()) {
            other->write(table);
        } else if (const auto found = value(key.name); found != plain.end()) {
            append({*found}, table);
        }
    }
    for (const Case& one : cases_) {
        const auto selector = value(one.selector);
        if (selector != plain.end() && selector->second == PlainValue(one.choice)) {
            append(one.keys.values(), table);
        }
    }
    return table;
}

}  // namespace ljmd
