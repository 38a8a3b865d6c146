#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ljmd {

/// The end of the string literal of TOML that begins at `start`: after its closing quotes, or at the end of its line.
[[nodiscard]] inline std::size_t skip_string(std::string_view text, std::size_t start) {
    const char quote = text[start];
    const bool multi_line = text.substr(start).starts_with(std::string(3, quote));
    const std::string closing(multi_line ? 3 : 1, quote);
    for (std::size_t i = start + closing.size(); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (text.substr(i).starts_with(closing)) {
            i += closing.size();
            // A multi-line string may end in up to two quotes of its own.
            for (int more = 0; multi_line && more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
            return i;
        } else if (text[i] == '\n' && !multi_line) {
            return i;
        }
    }
    return text.size();
}

}  // namespace ljmd
