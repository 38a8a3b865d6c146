#include "ljmd/core/description.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include "ljmd/core/section.hpp"

namespace ljmd {

namespace {

template <class T>
T value_of(const Section& section, const std::string& key) {
    if constexpr (std::is_same_v<T, bool>) {
        return section.flag(key);
    } else if constexpr (std::is_same_v<T, Index>) {
        return static_cast<Index>(section.integer(key));
    } else if constexpr (std::is_same_v<T, double>) {
        return section.number(key);
    } else {
        return section.text(key);
    }
}

template <class T>
void assign(T& member, const Section& section, const std::string& key) {
    member = value_of<T>(section, key);
}

template <class T>
void assign(std::optional<T>& member, const Section& section, const std::string& key) {
    member = section.has(key) ? std::optional(value_of<T>(section, key)) : std::nullopt;
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

Key& Description::add(Key key, Member member) {
    return items_.emplace_back(std::move(key), member).key;
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

void Description::take(const Section& section) {
    for (const Item& item : items_) {
        if (section.sound(item.key.name)) {
            std::visit([&](auto* member) { assign(*member, section, item.key.name); }, item.member);
        }
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
