#pragma once

#include <cstddef>

namespace ljmd {

/// Asks the system for so many bytes and gives them back untouched, before a library is called that does not survive
/// being refused some: FFTW ends the program (its assertion in alloc.c), HDF5 1.10 follows a null pointer when it
/// cannot open a file (H5AC_create). The memory may be gone again when the library asks; for one thread it is not.
/// @throws std::bad_alloc  they cannot be had
void require_memory(std::size_t bytes);

}  // namespace ljmd
