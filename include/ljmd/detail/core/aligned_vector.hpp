#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace ljmd {

/// Memory that begins at a cache line, which is also as wide as the widest vector register. Of large blocks the system
/// is asked for large pages: arrays of many atoms are read here and there, and each page that the processor has to look
/// up costs it some ten nanoseconds.
/// @throws std::bad_alloc
[[nodiscard]] void* allocate_aligned(std::size_t bytes);
/// @param bytes  as many as were allocated
void free_aligned(void* memory, std::size_t bytes) noexcept;

/// While it lives, large blocks that this thread allocates are passed to a function before anybody writes to them.
/// Where processors have memory of their own, a page lies with the processor that touches it first. Of several the last
/// one made counts.
class FirstTouch {
  public:
    using Function = std::function<void(std::byte* memory, std::size_t bytes)>;
    explicit FirstTouch(Function function);
    ~FirstTouch();
    FirstTouch(const FirstTouch&) = delete;
    FirstTouch& operator=(const FirstTouch&) = delete;

  private:
    Function function_;
    const Function* before_;
};

template <class T>
struct AlignedAllocator {
    using value_type = T;  // NOLINT(readability-identifier-naming): the standard asks for this name

    AlignedAllocator() = default;
    template <class Other>
    AlignedAllocator(const AlignedAllocator<Other>&) {}  // NOLINT(*-explicit-*): allocators convert

    T* allocate(std::size_t count) { return static_cast<T*>(allocate_aligned(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t count) { free_aligned(memory, count * sizeof(T)); }

    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace ljmd
