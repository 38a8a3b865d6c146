# Toolchain file: WebAssembly, by Debian's Emscripten. Vectors of 128 bits and exceptions as WebAssembly has them; what
# differs from one processor to the next ("relaxed" vectors) is not used.
#
# Eigen has no vectors of WebAssembly, but those of SSE2, which Emscripten translates. They are used because the order in
# which Eigen sums depends on them, and with it last digits.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_C_FLAGS_INIT "-msimd128 -fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -msse2 -fwasm-exceptions")
