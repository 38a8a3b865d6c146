#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

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

/// Shuffles within each 16 bytes of two vectors: lane I of the result is lane `pick[I mod 4]` of the 8 numbers that the
/// two have there.
template <int... pick>
struct InEachQuarter {
    template <class V, int... lane>
    LJMD_INLINE static V of(V p, V q, std::integer_sequence<int, lane...>) {
        constexpr int picks[] = {pick...};
        constexpr int lanes = sizeof...(lane);
        return __builtin_shufflevector(p, q,
                                       (lane / 4 * 4 + picks[lane % 4] % 4 + (picks[lane % 4] < 4 ? 0 : lanes))...);
    }
};

/// Point k in the first 16 bytes, point k + 4 in the second, and so on.
template <int lanes>
LJMD_INLINE RawVector<std::int32_t, lanes> every_fourth_point(const std::int32_t* points, const std::int32_t* entries) {
    if constexpr (lanes == 4) {
        return load<std::int32_t, 4>(address(points, entries[0]));
    } else {
        return joined<std::int32_t, lanes / 2>(every_fourth_point<lanes / 2>(points, entries),
                                               every_fourth_point<lanes / 2>(points, entries + lanes / 2));
    }
}

template <int lanes>
LJMD_INLINE Points<std::int32_t, lanes> load_fixed_points(const std::int32_t* points, const std::int32_t* entries) {
    using V = RawVector<std::int32_t, lanes>;
    constexpr auto all = std::make_integer_sequence<int, lanes>();
    const V a = every_fourth_point<lanes>(points, entries);
    const V b = every_fourth_point<lanes>(points, entries + 1);
    const V c = every_fourth_point<lanes>(points, entries + 2);
    const V d = every_fourth_point<lanes>(points, entries + 3);
    const V xy01 = InEachQuarter<0, 4, 1, 5>::of(a, b, all);
    const V xy23 = InEachQuarter<0, 4, 1, 5>::of(c, d, all);
    const V z01 = InEachQuarter<2, 6, 3, 7>::of(a, b, all);
    const V z23 = InEachQuarter<2, 6, 3, 7>::of(c, d, all);
    return {InEachQuarter<0, 1, 4, 5>::of(xy01, xy23, all), InEachQuarter<2, 3, 6, 7>::of(xy01, xy23, all),
            InEachQuarter<0, 1, 4, 5>::of(z01, z23, all)};
}

/// `lanes` points. @param entries  4 j of each point j
template <class T, int lanes>
LJMD_INLINE Points<T, lanes> load_points(const T* points, const std::int32_t* entries) {
    if constexpr (std::is_same_v<T, std::int32_t>) {
        return load_fixed_points<lanes>(points, entries);
    } else if constexpr (lanes == 2) {
        return load_points2(points, entries);
    } else if constexpr (lanes == 4) {
        return load_points4(points, entries);
    } else {
        return load_points8(points, entries);
    }
}

}  // namespace ljmd::simd
