#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ljmd {

/// Bytes as base64 (RFC 4648, with padding).
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

/// The bytes of numbers, little-endian.
template <class Number>
[[nodiscard]] std::string base64(const std::vector<Number>& numbers) {
    static_assert(std::is_arithmetic_v<Number> && std::endian::native == std::endian::little);
    return base64(std::as_bytes(std::span(numbers)));
}

}  // namespace ljmd
