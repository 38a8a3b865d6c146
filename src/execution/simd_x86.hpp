#pragma once

#include <immintrin.h>

#include <cstdint>

#include "execution/simd_raw.hpp"

/// Instructions of x86-64 for the operations in simd_intrinsics.hpp, as overloads for the vectors that have one. Other
/// vectors use the portable code there.
namespace ljmd::simd::native {

LJMD_INLINE RawVector<double, 2> square_root(RawVector<double, 2> x) {
    return _mm_sqrt_pd(x);
}
LJMD_INLINE RawVector<float, 4> square_root(RawVector<float, 4> x) {
    return _mm_sqrt_ps(x);
}
LJMD_INLINE RawVector<double, 2> larger(RawVector<double, 2> a, RawVector<double, 2> b) {
    return _mm_max_pd(a, b);
}
LJMD_INLINE RawVector<float, 4> larger(RawVector<float, 4> a, RawVector<float, 4> b) {
    return _mm_max_ps(a, b);
}
LJMD_INLINE RawVector<float, 4> smaller(RawVector<float, 4> a, RawVector<float, 4> b) {
    return _mm_min_ps(a, b);
}
LJMD_INLINE unsigned bits_of_less(RawVector<float, 4> a, RawVector<float, 4> b) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a, b)));
}

#if defined(__AVX2__) && defined(__FMA__)
LJMD_INLINE RawVector<double, 4> multiply_add(RawVector<double, 4> a, RawVector<double, 4> b, RawVector<double, 4> c) {
    return _mm256_fmadd_pd(a, b, c);
}
LJMD_INLINE RawVector<float, 8> multiply_add(RawVector<float, 8> a, RawVector<float, 8> b, RawVector<float, 8> c) {
    return _mm256_fmadd_ps(a, b, c);
}
LJMD_INLINE RawVector<double, 4> square_root(RawVector<double, 4> x) {
    return _mm256_sqrt_pd(x);
}
LJMD_INLINE RawVector<float, 8> square_root(RawVector<float, 8> x) {
    return _mm256_sqrt_ps(x);
}
LJMD_INLINE RawVector<double, 4> larger(RawVector<double, 4> a, RawVector<double, 4> b) {
    return _mm256_max_pd(a, b);
}
LJMD_INLINE RawVector<float, 8> larger(RawVector<float, 8> a, RawVector<float, 8> b) {
    return _mm256_max_ps(a, b);
}
#if !defined(__AVX512VL__)  // with it the compilers' operators become a mask and one instruction
// The compilers' operator becomes the integer instruction, whose result takes a cycle longer to reach a floating-point
// one.
LJMD_INLINE RawVector<double, 4> keep_where(RawVector<std::int64_t, 4> condition, RawVector<double, 4> x) {
    return _mm256_and_pd(reinterpret<__m256d>(condition), x);
}
LJMD_INLINE RawVector<float, 8> keep_where(RawVector<std::int32_t, 8> condition, RawVector<float, 8> x) {
    return _mm256_and_ps(reinterpret<__m256>(condition), x);
}
#endif
LJMD_INLINE RawVector<double, 4> widened(RawVector<float, 4> x) {
    return _mm256_cvtps_pd(x);
}
LJMD_INLINE RawVector<std::int32_t, 8> joined(RawVector<std::int32_t, 4> low, RawVector<std::int32_t, 4> high) {
    return reinterpret<RawVector<std::int32_t, 8>>(
        _mm256_inserti128_si256(_mm256_castsi128_si256(reinterpret<__m128i>(low)), reinterpret<__m128i>(high), 1));
}
LJMD_INLINE RawVector<float, 8> smaller(RawVector<float, 8> a, RawVector<float, 8> b) {
    return _mm256_min_ps(a, b);
}
LJMD_INLINE unsigned bits_of_less(RawVector<float, 8> a, RawVector<float, 8> b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)));
}

// From memory these compile to loads alone.
LJMD_INLINE RawVector<double, 4> repeated(RawVector<double, 2> two, RawVector<double, 4>) {
    return reinterpret<RawVector<double, 4>>(_mm256_broadcastsi128_si256(reinterpret<__m128i>(two)));
}
LJMD_INLINE RawVector<std::int32_t, 8> repeated(RawVector<std::int32_t, 4> four, RawVector<std::int32_t, 8>) {
    return reinterpret<RawVector<std::int32_t, 8>>(_mm256_broadcastsi128_si256(reinterpret<__m128i>(four)));
}

LJMD_INLINE RawVector<double, 4> each_repeated(RawVector<double, 2> two, RawVector<double, 4>) {
    return _mm256_permute4x64_pd(_mm256_castpd128_pd256(two), 0x50);
}
LJMD_INLINE RawVector<std::int32_t, 8> each_repeated(RawVector<std::int32_t, 2> two, RawVector<std::int32_t, 8>) {
    return reinterpret<RawVector<std::int32_t, 8>>(
        _mm256_permutevar8x32_epi32(_mm256_castsi128_si256(_mm_cvtsi64_si128(reinterpret<std::int64_t>(two))),
                                    _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1)));
}
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
LJMD_INLINE int pack(RawVector<std::int32_t, 8> v, unsigned bits, std::int32_t* to) {
    _mm256_storeu_si256(reinterpret<__m256i*>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), reinterpret<__m256i>(v)));
    return __builtin_popcount(bits);
}
LJMD_INLINE RawVector<double, 8> multiply_add(RawVector<double, 8> a, RawVector<double, 8> b, RawVector<double, 8> c) {
    return _mm512_fmadd_pd(a, b, c);
}
LJMD_INLINE RawVector<float, 16> multiply_add(RawVector<float, 16> a, RawVector<float, 16> b, RawVector<float, 16> c) {
    return _mm512_fmadd_ps(a, b, c);
}
LJMD_INLINE RawVector<double, 8> square_root(RawVector<double, 8> x) {
    return _mm512_sqrt_pd(x);
}
LJMD_INLINE RawVector<float, 16> square_root(RawVector<float, 16> x) {
    return _mm512_sqrt_ps(x);
}
LJMD_INLINE RawVector<double, 8> larger(RawVector<double, 8> a, RawVector<double, 8> b) {
    return _mm512_max_pd(a, b);
}
LJMD_INLINE RawVector<float, 16> larger(RawVector<float, 16> a, RawVector<float, 16> b) {
    return _mm512_max_ps(a, b);
}
LJMD_INLINE RawVector<double, 8> widened(RawVector<float, 8> x) {
    return _mm512_cvtps_pd(x);
}
LJMD_INLINE RawVector<double, 8> joined(RawVector<double, 4> low, RawVector<double, 4> high) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
}
LJMD_INLINE RawVector<std::int32_t, 16> joined(RawVector<std::int32_t, 8> low, RawVector<std::int32_t, 8> high) {
    return reinterpret<RawVector<std::int32_t, 16>>(
        _mm512_inserti64x4(_mm512_castsi256_si512(reinterpret<__m256i>(low)), reinterpret<__m256i>(high), 1));
}
LJMD_INLINE RawVector<float, 16> smaller(RawVector<float, 16> a, RawVector<float, 16> b) {
    return _mm512_min_ps(a, b);
}
LJMD_INLINE unsigned bits_of_less(RawVector<float, 16> a, RawVector<float, 16> b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
}
// Packed in a register, then stored: processors of AMD take a hundred cycles to pack into memory.
LJMD_INLINE int pack(RawVector<std::int32_t, 16> v, unsigned bits, std::int32_t* to) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), reinterpret<__m512i>(v)));
    return __builtin_popcount(bits);
}
LJMD_INLINE RawVector<double, 8> repeated(RawVector<double, 4> four, RawVector<double, 8>) {
    return _mm512_broadcast_f64x4(four);
}
LJMD_INLINE RawVector<std::int32_t, 16> repeated(RawVector<std::int32_t, 4> four, RawVector<std::int32_t, 16>) {
    return reinterpret<RawVector<std::int32_t, 16>>(_mm512_broadcast_i32x4(reinterpret<__m128i>(four)));
}
LJMD_INLINE RawVector<double, 8> each_repeated(RawVector<double, 2> two, RawVector<double, 8>) {
    return _mm512_permutexvar_pd(_mm512_setr_epi64(0, 0, 0, 0, 1, 1, 1, 1), _mm512_castpd128_pd512(two));
}
LJMD_INLINE RawVector<std::int32_t, 16> each_repeated(RawVector<std::int32_t, 4> four, RawVector<std::int32_t, 16>) {
    const __m512i atoms = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
    return reinterpret<RawVector<std::int32_t, 16>>(
        _mm512_permutexvar_epi32(atoms, _mm512_castsi128_si512(reinterpret<__m128i>(four))));
}
#endif

}  // namespace ljmd::simd::native
