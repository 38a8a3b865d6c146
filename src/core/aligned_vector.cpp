#include "ljmd/core/aligned_vector.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace ljmd {

namespace {

constexpr std::align_val_t cache_line{64};
/// Large pages of x86-64, and of most other processors.
constexpr std::align_val_t large_page{std::size_t{1} << 21};
/// From this size on large pages waste little.
constexpr std::size_t large_block = std::size_t{1} << 22;

std::align_val_t alignment_of(std::size_t bytes) {
    return bytes < large_block ? cache_line : large_page;
}

}  // namespace

void* allocate_aligned(std::size_t bytes) {
    void* memory = ::operator new(bytes, alignment_of(bytes));
#if defined(__linux__)
    if (bytes >= large_block) {
        static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));  // a wish: small pages do, too
    }
#endif
    return memory;
}

void free_aligned(void* memory, std::size_t bytes) noexcept {
    ::operator delete(memory, alignment_of(bytes));
}

}  // namespace ljmd
