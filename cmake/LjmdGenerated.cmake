# core/version.hpp, written by every build: the commit can change without a new configuration. The file is touched
# only when its text changes, and only src/core/build_info.cpp includes it, so that a new commit recompiles one file.
set(ljmd_version_include ${PROJECT_BINARY_DIR}/generated/private)

# The flags that can change numbers: optimization, machine, sanitizers and arithmetic. Others, such as those with which a
# distribution maps the paths of its build, would bring these paths into every run.json.
get_target_property(ljmd_flags ljmd_options INTERFACE_COMPILE_OPTIONS)
string(TOUPPER "${CMAKE_BUILD_TYPE}" ljmd_build_type)
separate_arguments(ljmd_own_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${ljmd_build_type}}")
list(PREPEND ljmd_flags ${ljmd_own_flags})
list(FILTER ljmd_flags INCLUDE REGEX "^-(O|m|DNDEBUG|f[a-z-]*(math|contract|precision|zeros|nans|store|sanitize|lto))")
list(JOIN ljmd_flags " " ljmd_flags)

# cli/example_deck_texts.hpp: the decks that `ljmd init` writes, and that `ljmd bench` runs when it is given none.
# continue.toml starts from the run of another deck.
file(GLOB ljmd_decks CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/inputs/*/*.toml)
list(FILTER ljmd_decks EXCLUDE REGEX "/continue\\.toml$")
list(LENGTH ljmd_decks ljmd_deck_count)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ljmd_decks})
set(ljmd_deck_texts "")
foreach(path IN LISTS ljmd_decks)
    get_filename_component(name ${path} NAME_WE)
    file(READ ${path} text)
    string(APPEND ljmd_deck_texts "    {\"${name}\", R\"deck(${text})deck\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${ljmd_version_include}/cli/example_deck_texts.hpp CONTENT
"#pragma once
// Written by cmake/LjmdGenerated.cmake from the decks in inputs/.
#include <array>

#include \"cli/example_decks.hpp\"

namespace ljmd {

inline constexpr std::array<ExampleDeck, @ljmd_deck_count@> example_deck_texts{{
@ljmd_deck_texts@}};

}  // namespace ljmd
" @ONLY)

add_custom_target(ljmd_version_header ALL
    COMMAND ${CMAKE_COMMAND}
            -D "source_dir=${PROJECT_SOURCE_DIR}"
            -D "template=${PROJECT_SOURCE_DIR}/cmake/version.hpp.in"
            -D "output=${ljmd_version_include}/core/version.hpp"
            -D "version=${PROJECT_VERSION}"
            -D "compiler=${CMAKE_CXX_COMPILER_ID}"
            -D "compiler_version=${CMAKE_CXX_COMPILER_VERSION}"
            -D "build_type=${CMAKE_BUILD_TYPE}"
            -D "flags=${ljmd_flags}"
            -P ${PROJECT_SOURCE_DIR}/cmake/WriteVersionHeader.cmake
    BYPRODUCTS ${ljmd_version_include}/core/version.hpp
    COMMENT "Asking git for the commit"
    VERBATIM)
