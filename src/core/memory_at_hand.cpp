#include "core/memory_at_hand.hpp"

#include <sys/mman.h>

#include <new>

namespace ljmd {

void require_memory(std::size_t bytes) {
    // Not by malloc: freeing a large block would change from what size on malloc leaves the heap.
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {  // NOLINT(performance-no-int-to-ptr): the system's macro
        throw std::bad_alloc();
    }
    munmap(memory, bytes);
}

}  // namespace ljmd
