#pragma once

#include <cstdint>

/// For functions of kernels: always inlined, so that no copy compiled for one processor can be linked in place of
/// another.
#define LJMD_INLINE [[gnu::always_inline]] inline

namespace ljmd::simd {

/// Width of the widest vector registers. From the instruction sets: __BIGGEST_ALIGNMENT__ is 16 with clang at every
/// level.
#if defined(__AVX512F__)
inline constexpr int widest_register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int widest_register_bytes = 32;
#else
inline constexpr int widest_register_bytes = 16;
#endif

/// Width of the vector registers that this translation unit computes with, and alignment of their types.
#if defined(LJMD_SIMD_256)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = widest_register_bytes;
#endif

/// Whether there are 32 vector registers and not 16.
#if defined(__AVX512VL__) || defined(__aarch64__)
inline constexpr bool many_registers = true;
#else
inline constexpr bool many_registers = false;
#endif

/// A vector type of the compilers' extension.
template <class T, int lanes>
struct RawVectorOf {
    typedef T Type __attribute__((vector_size(lanes * sizeof(T))));  // NOLINT(modernize-use-using): gcc wants a typedef
};
template <class T, int lanes>
using RawVector = typename RawVectorOf<T, lanes>::Type;

/// The signed integer type as wide as T.
template <class T>
struct Integer;
template <>
struct Integer<double> {
    using Type = std::int64_t;
};
template <>
struct Integer<float> {
    using Type = std::int32_t;
};

/// Reinterpret the bits as another type.
template <class To, class From>
LJMD_INLINE To reinterpret(From from) {
    return __builtin_bit_cast(To, from);
}

/// @pre aligned to the vector's own size
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> load_aligned(const T* from) {
    RawVector<T, lanes> v;
    __builtin_memcpy(&v, __builtin_assume_aligned(from, sizeof v), sizeof v);
    return v;
}

}  // namespace ljmd::simd
