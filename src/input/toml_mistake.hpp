#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ljmd {

/// What is wrong with a text that is no TOML.
struct TomlMistake {
    std::string message;
    std::string hint = {};
    std::size_t offset = 0;  ///< of what is wrong in the text
    std::size_t length = 0;  ///< of it; 0: the place where the parser stopped, which nothing is better than
};

/// Find out what is wrong by a look at the text about the place where the parser stopped. Its own words, which change
/// from version to version, count only where this finds nothing.
/// @param text  in UTF-8, without a NUL  @param stopped  offset  @param words  of the parser
[[nodiscard]] TomlMistake toml_mistake(std::string_view text, std::size_t stopped, std::string_view words);

}  // namespace ljmd
