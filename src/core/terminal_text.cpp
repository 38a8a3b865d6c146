#include "core/terminal_text.hpp"

#include "core/text.hpp"

namespace ljmd {

std::size_t harmless_length(std::string_view text) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return 0;
    const auto first = static_cast<unsigned char>(text[0]);
    const bool c1_control = length == 2 && first == 0xC2u && static_cast<unsigned char>(text[1]) < 0xA0u;
    return c1_control || first < 0x20u || first == 0x7Fu ? 0 : length;
}

}  // namespace ljmd
