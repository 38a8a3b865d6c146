#include "io/files/shell_word.hpp"

#include <string_view>

namespace ljmd {

std::string shell_word(const std::filesystem::path& path) {
    constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789@%_+=:,./-";
    const std::string text = (path.native().starts_with('-') ? "./" : "") + path.native();
    if (!text.empty() && text.find_first_not_of(harmless) == std::string::npos) {
        return text;
    }
    std::string word = "'";
    for (const char c : text) {
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return word + "'";
}

}  // namespace ljmd
