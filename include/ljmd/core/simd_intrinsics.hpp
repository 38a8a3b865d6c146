#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// For functions of kernels: inlined in every build, so that no copy for one processor can be shared with another.
#define LJMD_INLINE [[gnu::always_inline]] inline

/// What the vector extension of the compilers has no operator for. The only place with intrinsics; each function has a
/// portable body, and for x86-64 one of a single instruction.
namespace ljmd::simd {

/// Width of the vector registers that this translation unit is compiled for.
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

template <class T, int lanes>
struct RawVectorOf {
    typedef T Type __attribute__((vector_size(lanes * sizeof(T))));  // NOLINT(modernize-use-using): gcc wants a typedef
};
template <class T, int lanes>
using RawVector = typename RawVectorOf<T, lanes>::Type;

/// The signed integer as wide as T.
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
template <>
struct Integer<std::int32_t> {
    using Type = std::int32_t;
};

/// The same bits as another type.
template <class To, class From>
LJMD_INLINE To reinterpret(From from) {
    return __builtin_bit_cast(To, from);
}

/// Lanes that do not compare true become 0. @param condition  all bits set or none in each lane
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> keep_where(RawVector<typename Integer<T>::Type, lanes> condition,
                                           RawVector<T, lanes> x) {
    using Bits = RawVector<typename Integer<T>::Type, lanes>;
    return reinterpret<RawVector<T, lanes>>(condition & reinterpret<Bits>(x));
}

/// a b + c
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> multiply_add(RawVector<T, lanes> a, RawVector<T, lanes> b, RawVector<T, lanes> c) {
#if defined(__AVX512F__)
    if constexpr (sizeof(a) == 64 && sizeof(T) == 8) {
        return _mm512_fmadd_pd(a, b, c);
    } else if constexpr (sizeof(a) == 64 && sizeof(T) == 4) {
        return _mm512_fmadd_ps(a, b, c);
    } else
#endif
#if defined(__FMA__)
        if constexpr (sizeof(a) == 32 && sizeof(T) == 8) {
        return _mm256_fmadd_pd(a, b, c);
    } else if constexpr (sizeof(a) == 32 && sizeof(T) == 4) {
        return _mm256_fmadd_ps(a, b, c);
    } else
#endif
    {
        return a * b + c;
    }
}

template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> square_root(RawVector<T, lanes> x) {
#if defined(__AVX512F__)
    if constexpr (sizeof(x) == 64 && sizeof(T) == 8) {
        return _mm512_sqrt_pd(x);
    } else if constexpr (sizeof(x) == 64 && sizeof(T) == 4) {
        return _mm512_sqrt_ps(x);
    } else
#endif
#if defined(__AVX__)
        if constexpr (sizeof(x) == 32 && sizeof(T) == 8) {
        return _mm256_sqrt_pd(x);
    } else if constexpr (sizeof(x) == 32 && sizeof(T) == 4) {
        return _mm256_sqrt_ps(x);
    } else
#endif
#if defined(__x86_64__)
        if constexpr (sizeof(x) == 16 && sizeof(T) == 8) {
        return _mm_sqrt_pd(x);
    } else if constexpr (sizeof(x) == 16 && sizeof(T) == 4) {
        return _mm_sqrt_ps(x);
    } else
#endif
    {
        RawVector<T, lanes> result;
        for (int k = 0; k < lanes; ++k) {
            result[k] = static_cast<T>(__builtin_sqrt(x[k]));  // of a float it is the float's, rounded once
        }
        return result;
    }
}

/// Two vectors of half the length.
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes / 2> low_half(RawVector<T, lanes> v) {
    RawVector<T, lanes / 2> half;
    __builtin_memcpy(&half, &v, sizeof half);
    return half;
}
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes / 2> high_half(RawVector<T, lanes> v) {
    RawVector<T, lanes / 2> half;
    __builtin_memcpy(&half, reinterpret_cast<const char*>(&v) + sizeof half, sizeof half);
    return half;
}

/// One vector of two: the opposite of low_half and high_half. With gcc's shuffle the second would not be taken straight
/// from memory.
template <class T, int lanes>
LJMD_INLINE RawVector<T, 2 * lanes> joined(RawVector<T, lanes> low, RawVector<T, lanes> high) {
#if defined(__AVX512F__)
    if constexpr (sizeof(low) == 32) {
        return reinterpret<RawVector<T, 2 * lanes>>(
            _mm512_inserti64x4(_mm512_castsi256_si512(reinterpret<__m256i>(low)), reinterpret<__m256i>(high), 1));
    } else
#endif
#if defined(__AVX__)
        if constexpr (sizeof(low) == 16) {
        return reinterpret<RawVector<T, 2 * lanes>>(
            _mm256_insertf128_pd(_mm256_castpd128_pd256(reinterpret<__m128d>(low)), reinterpret<__m128d>(high), 1));
    } else
#endif
    {
        RawVector<T, 2 * lanes> both;
        __builtin_memcpy(&both, &low, sizeof low);
        __builtin_memcpy(reinterpret_cast<char*>(&both) + sizeof low, &high, sizeof high);
        return both;
    }
}

/// One bit a lane. @param condition  all bits set or none in each lane
template <int lanes>
LJMD_INLINE unsigned bits_of(RawVector<std::int32_t, lanes> condition) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    if constexpr (lanes == 16) {
        return _mm512_movepi32_mask(reinterpret<__m512i>(condition));
    } else
#endif
#if defined(__AVX2__)
        if constexpr (lanes == 8) {
        return static_cast<unsigned>(_mm256_movemask_ps(reinterpret<__m256>(condition)));
    } else
#endif
#if defined(__x86_64__)
        if constexpr (lanes == 4) {
        return static_cast<unsigned>(_mm_movemask_ps(reinterpret<__m128>(condition)));
    } else
#endif
    {
        unsigned bits = 0;
        for (int k = 0; k < lanes; ++k) {
            bits |= condition[k] != 0 ? 1U << k : 0U;
        }
        return bits;
    }
}

#if defined(__AVX2__)
/// Row b: the positions of the bits set in b, in ascending order, as 8 bytes.
struct BitPositions {
    std::uint64_t rows[256];
};
consteval BitPositions bit_positions() {
    BitPositions table{};
    for (unsigned bits = 0; bits < 256; ++bits) {
        int next = 0;
        for (unsigned k = 0; k < 8; ++k) {
            if ((bits >> k & 1U) != 0) {
                table.rows[bits] |= std::uint64_t{k} << (8 * next++);
            }
        }
    }
    return table;
}
inline constexpr BitPositions positions_of_bits = bit_positions();
#endif

/// Write the lanes of v whose bit is set to `out`, in order. @return how many
/// @pre room for `lanes` numbers at out: what follows those written may be overwritten
template <int lanes>
LJMD_INLINE int store_selected(std::int32_t* out, RawVector<std::int32_t, lanes> v, unsigned bits) {
#if defined(__AVX512F__)
    if constexpr (lanes == 16) {
        // To a register and then to memory: compressing stores are slow on some processors.
        _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), reinterpret<__m512i>(v)));
        return __builtin_popcount(bits);
    } else
#endif
#if defined(__AVX2__)
        if constexpr (lanes == 8) {
        const __m256i order =
            _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(positions_of_bits.rows[bits])));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                            _mm256_permutevar8x32_epi32(reinterpret<__m256i>(v), order));
        return __builtin_popcount(bits);
    } else
#endif
    {
        int count = 0;
        for (int k = 0; k < lanes; ++k) {
            out[count] = v[k];
            count += static_cast<int>(bits >> k & 1U);
        }
        return count;
    }
}

}  // namespace ljmd::simd
