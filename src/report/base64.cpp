#include "report/base64.hpp"

#include <string_view>

namespace ljmd {

std::string base64(std::span<const std::byte> bytes) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    constexpr std::size_t group = 3;       // bytes that become four digits
    constexpr unsigned bits = 6;           // of a digit
    constexpr unsigned last_digit = 0x3F;  // mask of its bits
    std::string text;
    text.reserve((bytes.size() + group - 1) / group * (group + 1));
    for (std::size_t k = 0; k < bytes.size(); k += group) {
        unsigned value = 0;
        for (std::size_t i = k; i < k + group; ++i) {
            value = (value << 8U) | (i < bytes.size() ? std::to_integer<unsigned>(bytes[i]) : 0U);
        }
        for (std::size_t i = 0; i <= group; ++i) {
            const bool is_padding = k + i > bytes.size();
            text += is_padding ? '=' : digits[(value >> (bits * (group - i))) & last_digit];
        }
    }
    return text;
}

}  // namespace ljmd
