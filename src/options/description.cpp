#include "ljmd/detail/options/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

template <class T>
void assign(T& member, const PlainValue& value) {
    member = std::get<T>(value);
}

template <class T>
void assign(std::optional<T>& member, const PlainValue& value) {
    member = std::get<T>(value);
}

void assign(Interval& member, const PlainValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        member = {.seconds = parse_wall_time(*text)};
    } else {
        member = {.steps = std::get<std::int64_t>(value)};
    }
}

void assign(const Description::Other& /*member*/, const PlainValue& /*value*/) {
    throw std::bad_variant_access();
}

const void* address_of(const void* member) {
    return member;
}

const void* address_of(const Description::Other& member) {
    return member.address;
}

/// Its value as a deck would write it.
PlainValue plain(const Interval& interval) {
    if (interval.steps) {
        return *interval.steps;
    }
    const double seconds = interval.seconds.value_or(0.0);
    const bool minutes = std::fmod(seconds, 60.0) == 0.0;
    return fmt::format("{} {}", minutes ? seconds / 60.0 : seconds, minutes ? "min" : "s");
}

template <class T>
std::optional<PlainValue> plain(const T& member) {
    if constexpr (std::is_same_v<T, Index>) {
        return PlainValue(std::int64_t{member});
    } else {
        return PlainValue(member);
    }
}

template <class T>
std::optional<PlainValue> plain(const std::optional<T>& member) {
    return member ? plain(*member) : std::nullopt;
}

std::optional<PlainValue> plain(const Description::Other& /*member*/) {
    return std::nullopt;
}

}  // namespace

Key& Description::add(const Key& key, Member member) {
    items_.push_back({key, member});
    return items_.back().key;
}

Key& Description::flag(const std::string& name, bool& member) {
    return add(Key::flag(name).defaults_to(member), &member);
}

Key& Description::flag(const std::string& name, std::optional<bool>& member) {
    return add(Key::flag(name).optional(), &member);
}

Key& Description::integer(const std::string& name, Index& member) {
    return add(Key::integer(name).defaults_to(member), &member);
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

Key& Description::text(const std::string& name, std::string& member) {
    return add(Key::text(name).defaults_to(member), &member);
}

Key& Description::text(const std::string& name, std::optional<std::string>& member) {
    return add(Key::text(name).optional(), &member);
}

Key& Description::choice(const std::string& name, const std::vector<std::string>& choices, std::string& member) {
    return add(Key::choice(name, choices).defaults_to(member), &member);
}

Key& Description::choice(const std::string& name, const std::vector<std::string>& choices,
                         std::optional<std::string>& member) {
    return add(Key::choice(name, choices).optional(), &member);
}

Key& Description::interval(const std::string& name, Interval& member) {
    return add(Key::interval(name).defaults_to(plain(member)), &member);
}

Key& Description::required_integer(const std::string& name, Index& member) {
    return add(Key::integer(name), &member);
}

Key& Description::required_number(const std::string& name, double& member) {
    return add(Key::number(name), &member);
}

Key& Description::required_text(const std::string& name, std::string& member) {
    return add(Key::text(name), &member);
}

Key& Description::required_choice(const std::string& name, const std::vector<std::string>& choices,
                                  std::string& member) {
    return add(Key::choice(name, choices), &member);
}

Key& Description::required_vector(const std::string& name, std::vector<double>& member) {
    return add(Key::vector(name), &member);
}

Key& Description::required_quantity(const std::string& name, Dimension dimension, double& member) {
    return add(Key::quantity(name, dimension), &member);
}

Key& Description::bind(const Key& key, double& member) {
    return add(key, &member);
}

std::vector<Key> Description::keys() const {
    std::vector<Key> keys;
    keys.reserve(items_.size());
    for (const Item& item : items_) {
        keys.push_back(item.key);
    }
    return keys;
}

const std::string* Description::key_of(const void* member) const {
    for (const Item& item : items_) {
        if (std::visit([](const auto& bound) { return address_of(bound); }, item.member) == member) {
            return &item.key.name;
        }
    }
    return nullptr;
}

void Description::take(const std::string& key, const PlainValue& value) {
    const auto item = std::ranges::find(items_, key, [](const Item& i) { return i.key.name; });
    if (item == items_.end()) {
        throw ContractViolation(fmt::format("there is no option '{}'", key));
    }
    try {
        std::visit([&](const auto& member) { assign(*member, value); }, item->member);
    } catch (const std::bad_variant_access&) {
        throw ContractViolation(fmt::format("option '{}' is of another type", key));
    }
}

Settings Description::values() const {
    Settings values;
    for (const Item& item : items_) {
        auto value =
            std::visit([](const auto& member) -> std::optional<PlainValue> { return plain(*member); }, item.member);
        if (value && item.key.kind == Kind::quantity) {
            value = quantity_text(std::get<double>(*value), item.key.physical_dimension);
        }
        if (value) {
            values.emplace_back(item.key.name, std::move(*value));
        }
    }
    return values;
}

}  // namespace ljmd
