#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/written_file.hpp"

/// What each source of this folder defines: one input is read. That it is refused in the way its reader documents is
/// fine; anything else that is thrown, a report of a sanitizer, a hang or too much memory is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ljmd::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// The input as a file, for readers that take a path.
inline const std::filesystem::path& file_of(const std::uint8_t* data, std::size_t size) {
    static const test::WrittenFile file("", "input");
    file.rewrite(text_of(data, size));
    return file.path();
}

/// Inputs that were read to their end and not refused. A corpus without any tries nothing behind the first check: the
/// seeds are of another version of a format.
inline int inputs_accepted = 0;

/// What must be so whatever the input is.
inline void require(bool so, const char* what) {
    if (!so) {
        throw std::logic_error(what);
    }
}

}  // namespace ljmd::fuzz
