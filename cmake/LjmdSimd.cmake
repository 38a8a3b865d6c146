# Kernels: every source in a folder src/<room>/simd is compiled once for each SIMD level that the compiler has flags for, with
# LJMD_SIMD_LEVEL set to the level's name as an identifier. ljmd_simd_objects holds the objects of all levels;
# execution/simd_levels.hpp lists the levels.
#
# portable is compiled with the flags of everything else. On ARM64 so is neon: all of these processors have it.
set(ljmd_simd_levels portable)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
    list(APPEND ljmd_simd_levels x86_64_v2 x86_64_v3 x86_64_v4 x86_64_v4_256 x86_64_v4_intel)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
    list(APPEND ljmd_simd_levels neon)
endif()

file(GLOB ljmd_simd_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/simd/*.cpp)
set(ljmd_simd_objects "")
foreach(level IN LISTS ljmd_simd_levels)
    add_library(ljmd_simd_${level} OBJECT ${ljmd_simd_sources})
    string(REGEX REPLACE "^x86_64_(v[0-9]).*" "x86-64-\\1" architecture ${level})
    # 512-bit registers are what v4 is for; the compilers' own choice would be half of them, which v4_256 is for. Without
    # -O3 and inlining, which the code counts on, a debugging build would be too slow for its tests.
    set(bits 512)
    if(level STREQUAL x86_64_v4_256)
        set(bits 256)
    endif()
    target_compile_options(ljmd_simd_${level} PRIVATE
        $<$<NOT:$<IN_LIST:${level},portable$<SEMICOLON>neon>>:-march=${architecture}>
        $<$<STREQUAL:${architecture},x86-64-v4>:-mprefer-vector-width=${bits}>
        $<$<NOT:$<CONFIG:Debug>>:-O3>
        # All functions with vectors as arguments are inlined: how they would be passed is of no account.
        -Wno-psabi
        # To tell a debugger where each variable is takes gcc about as long as all else that it does with such functions.
        $<$<CXX_COMPILER_ID:GNU>:-fno-var-tracking>
        # Before version 13 gcc takes its own headers of AVX-512 to use what is not set (its bug 105593).
        $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_compile_definitions(ljmd_simd_${level} PRIVATE LJMD_SIMD_LEVEL=${level}
        $<$<STREQUAL:${level},neon>:LJMD_SIMD_NEON>
        $<$<STREQUAL:${level},x86_64_v4_256>:LJMD_SIMD_256>
        $<$<STREQUAL:${level},x86_64_v4_intel>:LJMD_SIMD_FOR_INTEL>)
    target_include_directories(ljmd_simd_${level} PRIVATE ${PROJECT_SOURCE_DIR}/include
                                                          ${PROJECT_BINARY_DIR}/generated/include)
    target_link_libraries(ljmd_simd_${level} PRIVATE Eigen3::Eigen ljmd_options)
    ljmd_for_extension(ljmd_simd_${level})
    list(APPEND ljmd_simd_objects $<TARGET_OBJECTS:ljmd_simd_${level}>)
endforeach()

set(tags "")
set(values "")
set(cases "")
foreach(level IN LISTS ljmd_simd_levels)
    string(APPEND tags "struct ${level};\n")
    string(APPEND values "SimdLevel::${level}, ")
    string(APPEND cases "        case SimdLevel::${level}:\n            return compiled_here<Kernel, ${level}>();\n")
endforeach()
string(REGEX REPLACE ", $" "" values "${values}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/include/execution/simd_levels.hpp CONTENT
"#pragma once
// Written by cmake/LjmdSimd.cmake.
#include <array>

#include \"ljmd/core/errors.hpp\"
#include \"ljmd/detail/execution/simd.hpp\"

namespace ljmd::simd {

@tags@

inline constexpr std::array levels{@values@};

/// The kernels of that type as compiled for one level; defined in a source of src/<room>/simd.
template <class Kernel, class Level>
Kernel compiled_here();

/// Those of a level. @throws ContractViolation when the level is not compiled in
template <class Kernel>
Kernel compiled_for(SimdLevel level) {
    switch (level) {
@cases@
        default:
            throw ContractViolation(\"this program has no code for that SIMD level\");
    }
}

}  // namespace ljmd::simd
" @ONLY)
