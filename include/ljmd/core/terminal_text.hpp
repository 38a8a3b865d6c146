#pragma once

#include <cstddef>
#include <string_view>

namespace ljmd {

/// Bytes of the character that `text` begins with, or 0 when a terminal must not get it: a control character (which
/// moves the cursor, changes the title of the window or types for the user) or no UTF-8.
[[nodiscard]] std::size_t harmless_length(std::string_view text);

}  // namespace ljmd
