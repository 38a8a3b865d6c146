#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/written_file.hpp"

namespace ljmd::fuzz {

/// Reads one input. That it is refused in the way its reader documents is fine; anything else that is thrown, a report
/// of a sanitizer, a hang or too much memory is a finding. @return 0
using Target = int (*)(const std::uint8_t* data, std::size_t size);

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

/// Without libFuzzer: the targets of the program by their names.
inline std::map<std::string_view, Target>& targets() {
    static std::map<std::string_view, Target> all;
    return all;
}

}  // namespace ljmd::fuzz

/// What each source of this folder defines, named like the source: LJMD_FUZZ_TARGET(name) { ... } reads `data` of
/// length `size`. With libFuzzer it is the one function that this calls.
#ifdef LJMD_FUZZERS
#define LJMD_FUZZ_TARGET(name) extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#else
#define LJMD_FUZZ_TARGET(name)                                                                    \
    static int fuzz_##name(const std::uint8_t* data, std::size_t size);                           \
    static const bool name##_is_known = ljmd::fuzz::targets().emplace(#name, fuzz_##name).second; \
    static int fuzz_##name(const std::uint8_t* data, std::size_t size)
#endif
