# Writes files as arrays of words of eight bytes, the first byte lowest: a compiler takes a fifth of a second for them,
# whatever its assembler, and seconds for the same text as a literal. Run as a script:
#
#     cmake -D frame=FILE -D style=FILE -D script=FILE -D output=HEADER -P WritePageArrays.cmake
set(text "#pragma once\n// Written by cmake/WritePageArrays.cmake.\n#include <array>\n#include <cstddef>\n#include <cstdint>\n\n")
foreach(part frame style script)
    file(READ ${${part}} bytes HEX)
    string(LENGTH "${bytes}" digits)
    math(EXPR size "${digits} / 2")
    math(EXPR count "(${size} + 7) / 8")
    string(APPEND bytes 00000000000000)
    string(REGEX REPLACE "(..)(..)(..)(..)(..)(..)(..)(..)" "0x\\8\\7\\6\\5\\4\\3\\2\\1,\n" words "${bytes}")
    string(REGEX REPLACE "\n[0-9a-f]*$" "\n" words "${words}")
    string(APPEND text "inline constexpr std::size_t page_${part}_size = ${size};\n"
                       "inline constexpr std::array<std::uint64_t, ${count}> page_${part}{\n${words}};\n")
endforeach()
file(WRITE ${output} "${text}")
