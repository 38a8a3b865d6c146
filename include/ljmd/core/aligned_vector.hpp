#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace ljmd {

/// Allocator of memory that begins at a cache line, which is also as wide as the widest vector register.
template <class T>
struct AlignedAllocator {
    using value_type = T;  // NOLINT(readability-identifier-naming): the standard asks for this name
    static constexpr std::align_val_t alignment{64};

    AlignedAllocator() = default;
    template <class Other>
    AlignedAllocator(const AlignedAllocator<Other>&) {}  // NOLINT(*-explicit-*): allocators convert

    T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
    void deallocate(T* memory, std::size_t) { ::operator delete(memory, alignment); }

    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace ljmd
