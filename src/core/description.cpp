#include "ljmd/core/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

template <class T>
T value_of(const PlainValue& value) {
    if constexpr (std::is_same_v<T, Index>) {
        return static_cast<Index>(std::get<std::int64_t>(value));
    } else {
        return std::get<T>(value);
    }
}

template <class T>
void assign(T& member, const PlainValue& value) {
    member = value_of<T>(value);
}

template <class T>
void assign(std::optional<T>& member, const PlainValue& value) {
    member = value_of<T>(value);
}

template <class T>
std::string in_words(const std::string& key, const T& value) {
    return fmt::format("{}={}", key, value);
}

template <class T>
std::string in_words(const std::string& key, const std::optional<T>& value) {
    return value ? in_words(key, *value) : "";
}

}  // namespace

Key& Description::add(const Key& key, Member member) {
    items_.push_back({key, member});
    return items_.back().key;
}

Key& Description::flag(const std::string& name, bool& member) {
    return add(Key::flag(name).defaults_to(member), &member);
}

Key& Description::integer(const std::string& name, Index& member) {
    return add(Key::integer(name).defaults_to(static_cast<std::int64_t>(member)), &member);
}

Key& Description::integer(const std::string& name, std::optional<Index>& member) {
    return add(Key::integer(name).optional(), &member);
}

Key& Description::number(const std::string& name, double& member) {
    return add(Key::number(name).defaults_to(member), &member);
}

Key& Description::number(const std::string& name, std::optional<double>& member) {
    return add(Key::number(name).optional(), &member);
}

Key& Description::choice(const std::string& name, const std::vector<std::string>& choices, std::string& member) {
    return add(Key::choice(name, choices).defaults_to(member), &member);
}

Key& Description::required_integer(const std::string& name, Index& member) {
    return add(Key::integer(name), &member);
}

Key& Description::required_number(const std::string& name, double& member) {
    return add(Key::number(name), &member);
}

std::vector<Key> Description::keys() const {
    std::vector<Key> keys;
    keys.reserve(items_.size());
    for (const Item& item : items_) {
        keys.push_back(item.key);
    }
    return keys;
}

void Description::take(const std::string& key, const PlainValue& value) {
    const auto item = std::ranges::find(items_, key, [](const Item& i) { return i.key.name; });
    if (item == items_.end()) {
        throw ContractViolation(fmt::format("there is no option '{}'", key));
    }
    try {
        std::visit([&](auto* member) { assign(*member, value); }, item->member);
    } catch (const std::bad_variant_access&) {
        throw ContractViolation(fmt::format("option '{}' is of another type", key));
    }
}

std::string Description::values_in_words() const {
    std::string text;
    for (const Item& item : items_) {
        const std::string words =
            std::visit([&](const auto* member) { return in_words(item.key.name, *member); }, item.member);
        text += (text.empty() || words.empty() ? "" : " ") + words;
    }
    return text;
}

}  // namespace ljmd
