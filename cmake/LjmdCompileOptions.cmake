# Options that every target of this project is compiled with, as the interface target ljmd_options.
add_library(ljmd_options INTERFACE)
target_compile_features(ljmd_options INTERFACE cxx_std_20)
# Headers that are installed lie in include/; all others beside the sources, from where they are named.
target_include_directories(ljmd_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(ljmd_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
    # Floating point: contraction would make results depend on the compiler's mood; the two others change no result and
    # are what vectorisation needs. -ffast-math is never used.
    -ffp-contract=off -fno-math-errno -fno-trapping-math
    # Names of sources in assertions say where a file lies in the project, not where the project lay when it was built.
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
# Before version 13 gcc warns of overlaps in std::string that cannot be (its bug 105651), and, where that comes from a
# precompiled header, of its bounds.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(ljmd_options INTERFACE -Wno-restrict -Wno-array-bounds)
endif()
# Before version 20 libc++ cannot read numbers by std::from_chars(): fast_float does.
if(NOT EMSCRIPTEN)
    include(CheckCXXSourceCompiles)
    set(CMAKE_REQUIRED_FLAGS -std=c++20)
    check_cxx_source_compiles("#include <charconv>
        int main() { double x = 0.0; return static_cast<int>(std::from_chars(nullptr, nullptr, x).ec); }" LJMD_READS_NUMBERS)
    unset(CMAKE_REQUIRED_FLAGS)
    if(NOT LJMD_READS_NUMBERS)
        find_path(LJMD_FAST_FLOAT fast_float/fast_float.h)
        if(NOT LJMD_FAST_FLOAT)
            message(FATAL_ERROR "fast_float was not found, which the standard library of this compiler (libc++ before version 20) "
                                "needs to read numbers. -D LJMD_FAST_FLOAT=<folder> tells where its headers are.")
        endif()
        target_include_directories(ljmd_options SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/src/core/compat ${LJMD_FAST_FLOAT})
    endif()
endif()
if(LJMD_WARNINGS_AS_ERRORS)
    target_compile_options(ljmd_options INTERFACE -Werror)
endif()

# What most sources include is parsed once for a target, not once for each source: compiling takes two fifths less time.
# Sources do not count on it, and name what they need: where CMAKE_DISABLE_PRECOMPILE_HEADERS is set, as in the preset
# clang, they compile without.
set(ljmd_precompiled_headers <Eigen/Geometry> <fmt/format.h> <algorithm> <array> <cmath> <cstdint> <filesystem>
                             <functional> <memory> <optional> <string> <string_view> <utility> <vector>)
