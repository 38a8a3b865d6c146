#pragma once

#include <cstddef>
#include <string_view>

namespace ljmd {

/// Length in bytes of the first character of `text`; 0 if it must not reach a terminal. Those are invalid UTF-8 and
/// control characters, which can move the cursor, change the window title or type for the user.
[[nodiscard]] std::size_t harmless_length(std::string_view text);

}  // namespace ljmd
