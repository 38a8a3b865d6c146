#pragma once

#include <cstdint>

#include "ljmd/core/simd_intrinsics.hpp"

/// Points scattered in memory, four numbers each, as vectors of their x, y and z. Loads of whole points and shuffles:
/// on all processors tried much faster than gather instructions. The order of the points in the vectors is any, the
/// same in all three.
namespace ljmd::simd {

template <class T, int lanes>
struct Points {
    RawVector<T, lanes> x;
    RawVector<T, lanes> y;
    RawVector<T, lanes> z;
};

/// @pre aligned to its own size
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> load(const T* from) {
    RawVector<T, lanes> v;
    __builtin_memcpy(&v, __builtin_assume_aligned(from, sizeof v), sizeof v);
    return v;
}

/// @param entry  4 j of a point j, as an unsigned number
template <class T>
LJMD_INLINE const T* address(const T* points, std::int32_t entry) {
    return points + static_cast<std::uint32_t>(entry);
}

LJMD_INLINE Points<double, 2> load_points2(const double* points, const std::int32_t* entries) {
    const double* p0 = address(points, entries[0]);
    const double* p1 = address(points, entries[1]);
    const auto xy0 = load<double, 2>(p0);
    const auto xy1 = load<double, 2>(p1);
    return {__builtin_shufflevector(xy0, xy1, 0, 2), __builtin_shufflevector(xy0, xy1, 1, 3),
            RawVector<double, 2>{p0[2], p1[2]}};
}

/// x y (or z 0) of two points.
LJMD_INLINE RawVector<double, 4> two_halves(const double* a, const double* b) {
    return joined<double, 2>(load<double, 2>(a), load<double, 2>(b));
}

LJMD_INLINE Points<double, 4> load_points4(const double* points, const std::int32_t* entries) {
    const double* p0 = address(points, entries[0]);
    const double* p1 = address(points, entries[1]);
    const double* p2 = address(points, entries[2]);
    const double* p3 = address(points, entries[3]);
    const auto xy02 = two_halves(p0, p2);
    const auto xy13 = two_halves(p1, p3);
    const auto z02 = two_halves(p0 + 2, p2 + 2);
    const auto z13 = two_halves(p1 + 2, p3 + 2);
    return {__builtin_shufflevector(xy02, xy13, 0, 4, 2, 6), __builtin_shufflevector(xy02, xy13, 1, 5, 3, 7),
            __builtin_shufflevector(z02, z13, 0, 4, 2, 6)};
}

/// Two whole points.
LJMD_INLINE RawVector<double, 8> two_points(const double* points, std::int32_t a, std::int32_t b) {
    return joined<double, 4>(load<double, 4>(address(points, a)), load<double, 4>(address(points, b)));
}

LJMD_INLINE Points<double, 8> load_points8(const double* points, const std::int32_t* e) {
    const auto p04 = two_points(points, e[0], e[4]);
    const auto p15 = two_points(points, e[1], e[5]);
    const auto p26 = two_points(points, e[2], e[6]);
    const auto p37 = two_points(points, e[3], e[7]);
    const auto xz0145 = __builtin_shufflevector(p04, p15, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto xz2367 = __builtin_shufflevector(p26, p37, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto y0145 = __builtin_shufflevector(p04, p15, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto y2367 = __builtin_shufflevector(p26, p37, 1, 9, 3, 11, 5, 13, 7, 15);
    return {__builtin_shufflevector(xz0145, xz2367, 0, 1, 4, 5, 8, 9, 12, 13),
            __builtin_shufflevector(y0145, y2367, 0, 1, 4, 5, 8, 9, 12, 13),
            __builtin_shufflevector(xz0145, xz2367, 2, 3, 6, 7, 10, 11, 14, 15)};
}

using Ints4 = RawVector<std::int32_t, 4>;
using Ints8 = RawVector<std::int32_t, 8>;
using Ints16 = RawVector<std::int32_t, 16>;

LJMD_INLINE Points<std::int32_t, 4> load_points4(const std::int32_t* points, const std::int32_t* e) {
    const auto point = [&](int k) { return load<std::int32_t, 4>(address(points, e[k])); };
    const Ints4 a = point(0);
    const Ints4 b = point(1);
    const Ints4 c = point(2);
    const Ints4 d = point(3);
    const Ints4 xy01 = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Ints4 xy23 = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Ints4 z01 = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Ints4 z23 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    return {__builtin_shufflevector(xy01, xy23, 0, 1, 4, 5), __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7),
            __builtin_shufflevector(z01, z23, 0, 1, 4, 5)};
}

/// The same in each half of a register.
LJMD_INLINE Points<std::int32_t, 8> load_points8(const std::int32_t* points, const std::int32_t* e) {
    const auto pair = [&](int k) {
        return joined<std::int32_t, 4>(load<std::int32_t, 4>(address(points, e[k])),
                                       load<std::int32_t, 4>(address(points, e[k + 4])));
    };
    const Ints8 a = pair(0);
    const Ints8 b = pair(1);
    const Ints8 c = pair(2);
    const Ints8 d = pair(3);
    const Ints8 xy01 = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Ints8 xy23 = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Ints8 z01 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Ints8 z23 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(z01, z23, 0, 1, 8, 9, 4, 5, 12, 13)};
}

/// The same in each quarter.
LJMD_INLINE Points<std::int32_t, 16> load_points16(const std::int32_t* points, const std::int32_t* e) {
    const auto two = [&](int k) {
        return joined<std::int32_t, 4>(load<std::int32_t, 4>(address(points, e[k])),
                                       load<std::int32_t, 4>(address(points, e[k + 4])));
    };
    const auto four = [&](int k) { return joined<std::int32_t, 8>(two(k), two(k + 8)); };
    const Ints16 a = four(0);
    const Ints16 b = four(1);
    const Ints16 c = four(2);
    const Ints16 d = four(3);
    const auto low = [](Ints16 p, Ints16 q) {
        return __builtin_shufflevector(p, q, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    };
    const auto high = [](Ints16 p, Ints16 q) {
        return __builtin_shufflevector(p, q, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    };
    const auto first_pairs = [](Ints16 p, Ints16 q) {
        return __builtin_shufflevector(p, q, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    };
    const auto second_pairs = [](Ints16 p, Ints16 q) {
        return __builtin_shufflevector(p, q, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
    };
    return {first_pairs(low(a, b), low(c, d)), second_pairs(low(a, b), low(c, d)), first_pairs(high(a, b), high(c, d))};
}

/// `lanes` points. @param entries  4 j of each point j
template <class T, int lanes>
LJMD_INLINE Points<T, lanes> load_points(const T* points, const std::int32_t* entries) {
    if constexpr (lanes == 2) {
        return load_points2(points, entries);
    } else if constexpr (lanes == 4) {
        return load_points4(points, entries);
    } else if constexpr (lanes == 8) {
        return load_points8(points, entries);
    } else {
        return load_points16(points, entries);
    }
}

}  // namespace ljmd::simd
