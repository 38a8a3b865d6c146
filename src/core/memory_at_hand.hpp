#pragma once

#include <cstddef>

namespace ljmd {

/// Check that `bytes` bytes can be allocated, before a call of a library that does not survive a failed allocation:
/// FFTW ends the program (assertion in alloc.c), and HDF5 1.10 dereferences a null pointer if it cannot open a file
/// (H5AC_create). The memory is allocated and freed again, untouched; in a process with one thread it is then still
/// available.
/// @throws std::bad_alloc if it is not
void require_memory(std::size_t bytes);

}  // namespace ljmd
