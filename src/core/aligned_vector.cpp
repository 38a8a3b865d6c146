#include "ljmd/detail/core/aligned_vector.hpp"

#include <new>
#include <utility>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

#if defined(__SANITIZE_ADDRESS__)
#define LJMD_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LJMD_ADDRESS_SANITIZER
#endif
#endif

namespace ljmd {

namespace {

constexpr std::align_val_t cache_line{64};

/// Blocks of this size on are mapped by themselves. What is given back then belongs to the system again; among small
/// blocks it would stay with the process, and the next larger block would not fit into it.
constexpr std::size_t mapped_block = std::size_t{1} << 20;
/// From this size on large pages waste little.
constexpr std::size_t large_block = std::size_t{1} << 22;
/// Large pages of x86-64, and of most other processors.
constexpr std::size_t large_page = std::size_t{1} << 21;

#if defined(__linux__) && !defined(LJMD_ADDRESS_SANITIZER)

std::byte* map(std::size_t bytes) {
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        throw std::bad_alloc();
    }
    return static_cast<std::byte*>(memory);
}

void unmap(std::byte* memory, std::size_t bytes) {
    if (bytes > 0) {
        munmap(memory, bytes);
    }
}

/// A block that begins at a large page.
std::byte* map_large(std::size_t bytes) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t whole = (bytes + page - 1) / page * page;
    std::byte* memory = map(whole + large_page);
    const std::size_t before = (large_page - reinterpret_cast<std::uintptr_t>(memory) % large_page) % large_page;
    unmap(memory, before);
    unmap(memory + before + whole, large_page - before);
    static_cast<void>(madvise(memory + before, whole, MADV_HUGEPAGE));  // a wish: small pages do, too
    return memory + before;
}

#else  // the sanitizer watches what it allocates alone

std::byte* map(std::size_t bytes) {
    return static_cast<std::byte*>(::operator new (bytes, std::align_val_t{large_page}));
}

void unmap(std::byte* memory, std::size_t /*bytes*/) {
    ::operator delete (memory, std::align_val_t{large_page});
}

std::byte* map_large(std::size_t bytes) {
    return map(bytes);
}

#endif

thread_local const FirstTouch::Function* first_touch = nullptr;

}  // namespace

FirstTouch::FirstTouch(Function function)
    : function_(std::move(function)), before_(std::exchange(first_touch, &function_)) {}

FirstTouch::~FirstTouch() {
    first_touch = before_;
}

void* allocate_aligned(std::size_t bytes) {
    if (bytes >= mapped_block) {
        std::byte* memory = bytes < large_block ? map(bytes) : map_large(bytes);
        if (first_touch != nullptr) {
            (*first_touch)(memory, bytes);
        }
        return memory;
    }
    return ::operator new(bytes, cache_line);
}

void free_aligned(void* memory, std::size_t bytes) noexcept {
    if (bytes >= mapped_block) {
        unmap(static_cast<std::byte*>(memory), bytes);
        return;
    }
    ::operator delete(memory, cache_line);
}

}  // namespace ljmd
