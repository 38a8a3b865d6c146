#pragma once

#include <cstddef>

#include "forces/simd/pair_arithmetic.hpp"

/// From sums over lanes to the forces on the atoms of a cluster.
/// All names have internal linkage: the linker could otherwise take a function compiled for one processor in place of
/// the same one compiled for another.
namespace ljmd {

namespace {

LJMD_INLINE Four in_double(Four x) {
    return x;
}
LJMD_INLINE Four in_double(simd::RawVector<float, slots> x) {
    return simd::widened<slots>(x);
}

// Sums over the slots of each atom of a cluster: first over slots 0 and 1, and over 2 and 3, in the precision of the
// pair terms, then both in double. @param rows  sums of each row, by halves of clusters and lanes
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 2> (&rows)[2][4]) {
    Four sums[2];
    for (int half = 0; half < 2; ++half) {
        const auto& r = rows[half];
        sums[half] = Four{r[0][0] + r[0][1], r[1][0] + r[1][1], r[2][0] + r[2][1], r[3][0] + r[3][1]};
    }
    return sums[0] + sums[1];
}
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 4> (&rows)[2][2]) {
    Four sums[2];
    for (int half = 0; half < 2; ++half) {
        const auto [a, b] = rows[half];
        sums[half] = in_double(__builtin_shufflevector(a, b, 0, 2, 4, 6) + __builtin_shufflevector(a, b, 1, 3, 5, 7));
    }
    return sums[0] + sums[1];
}
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 8> (&rows)[1][2]) {
    const auto [a, b] = rows[0];
    const auto ab = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
                    __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    return in_double(__builtin_shufflevector(ab, ab, 0, 4, 1, 5)) +
           in_double(__builtin_shufflevector(ab, ab, 2, 6, 3, 7));
}
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 16> (&rows)[1][1]) {
    const auto a = rows[0][0];
    const auto twos = a + __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14);
    return in_double(__builtin_shufflevector(twos, twos, 0, 4, 8, 12)) +
           in_double(__builtin_shufflevector(twos, twos, 2, 6, 10, 14));
}

/// Sum of the pieces of a vector, each of `piece` lanes.
template <int piece, class T, int lanes>
LJMD_INLINE simd::RawVector<T, piece> sum_of_pieces(simd::RawVector<T, lanes> v) {
    if constexpr (lanes == piece) {
        return v;
    } else {
        return sum_of_pieces<piece, T, lanes / 2>(simd::low_half<T, lanes>(v) + simd::high_half<T, lanes>(v));
    }
}

/// Partial forces of a cluster along one axis: for each of its parts a piece, with lanes for each reacting atom.
template <class V>
constexpr int partial_lanes = others_per_row<V>* reaction_atoms<V>;
template <class V>
constexpr std::size_t partial_forces = std::size_t{parts_per_cluster<V>} * partial_lanes<V>;

/// Minus the forces of earlier rows on the atoms of a cluster, along one axis; they are set to zero. Forces of the
/// first half of the reacting atoms are added to the second half's.
template <class V>
LJMD_INLINE Four take_from_others(typename V::Value* others) {
    using T = typename V::Value;
    constexpr int part = others_per_row<V>;
    constexpr int lanes = partial_lanes<V>;
    const auto take = [](T* from) {
        const auto all = simd::load_aligned<T, lanes>(from);
        const simd::RawVector<T, lanes> none{};
        __builtin_memcpy(__builtin_assume_aligned(from, sizeof none), &none, sizeof none);
        return sum_of_pieces<part, T, lanes>(all);
    };
    const auto first = take(others);
    if constexpr (parts_per_cluster<V> == 1) {
        return in_double(first);
    } else {
        const auto second = take(others + lanes);
        return in_double(__builtin_shufflevector(first, second, 0, 1, 2, 3));
    }
}

/// Write the forces on the atoms of a cluster, x y z 0 each.
/// @tparam stride  from one x to the next; with 3, the 0 of each atom but the last is overwritten
/// @param f  forces on the atoms along each axis
template <std::size_t stride>
LJMD_INLINE void write_forces(const Four (&f)[3], std::size_t atoms, double* to) {
    const Four none{};
    const Four xy01 = __builtin_shufflevector(f[0], f[1], 0, 4, 1, 5);
    const Four xy23 = __builtin_shufflevector(f[0], f[1], 2, 6, 3, 7);
    const Four z01 = __builtin_shufflevector(f[2], none, 0, 4, 1, 5);
    const Four z23 = __builtin_shufflevector(f[2], none, 2, 6, 3, 7);
    const auto write = [&](std::size_t k, Four of_atom) {
        if (k < atoms) {
            __builtin_memcpy(to + stride * k, &of_atom, sizeof of_atom);
        }
    };
    write(0, __builtin_shufflevector(xy01, z01, 0, 1, 4, 5));
    write(1, __builtin_shufflevector(xy01, z01, 2, 3, 6, 7));
    write(2, __builtin_shufflevector(xy23, z23, 0, 1, 4, 5));
    write(3, __builtin_shufflevector(xy23, z23, 2, 3, 6, 7));
}

}  // namespace

}  // namespace ljmd
