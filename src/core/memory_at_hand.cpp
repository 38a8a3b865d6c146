#include "ljmd/core/memory_at_hand.hpp"

#include <sys/mman.h>

#include <new>

namespace ljmd {

void require_memory(std::size_t bytes) {
    // Not by malloc: given back, a large block would change which sizes malloc takes from the heap from then on.
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {  // NOLINT(performance-no-int-to-ptr): the system's macro
        throw std::bad_alloc();
    }
    munmap(memory, bytes);
}

}  // namespace ljmd
