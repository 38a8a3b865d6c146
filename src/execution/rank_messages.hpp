#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "execution/ranks.hpp"

namespace ljmd {

/// Values as a message to another rank, and back.
template <class T>
[[nodiscard]] Ranks::Bytes message_of(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    Ranks::Bytes message(values.size() * sizeof(T));
    if (!values.empty()) {  // memcpy takes no null pointer, even for zero bytes
        std::memcpy(message.data(), values.data(), message.size());
    }
    return message;
}

template <class T>
[[nodiscard]] std::vector<T> values_of(const Ranks::Bytes& message) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(message.size() / sizeof(T));
    if (!values.empty()) {
        std::memcpy(values.data(), message.data(), message.size());
    }
    return values;
}

}  // namespace ljmd
