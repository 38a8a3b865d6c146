#pragma once

#include <cstddef>
#include <cstdint>

#include "execution/simd_vector.hpp"
#include "forces/simd/pair_kernel.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"
#include "neighbors/cluster_grid.hpp"

/// How the atoms of rows and parts lie in the lanes of vectors, and their separations in either precision.
/// All names have internal linkage: the linker could otherwise take a function compiled for one processor in place of
/// the same one compiled for another.
namespace ljmd {

namespace {

inline constexpr int slots = ClusterGrid::slots;
using Four = simd::RawVector<double, slots>;

/// Offsets from the x of a cluster's slots to their y and z.
inline constexpr std::ptrdiff_t to_y = slots;
inline constexpr std::ptrdiff_t to_z = std::ptrdiff_t{2} * slots;

/// A row of atoms meets a part of a cluster (see RowShape): lane others * n + k is for atom n of the row and slot k of
/// the part.
template <class V>
constexpr int others_per_row = V::lanes <= 4 ? 2 : 4;
template <class V>
constexpr int atoms_per_row = V::lanes / others_per_row<V>;
template <class V>
constexpr int rows_per_cluster = slots / atoms_per_row<V>;
template <class V>
constexpr int parts_per_cluster = slots / others_per_row<V>;

/// Atoms of a cluster whose forces on others are added up apart from the next atoms' forces. It is the same at all
/// levels, as the order of sums is: 2 in double precision, 4 in single precision, the widest rows.
template <class V>
constexpr int reaction_atoms = sizeof(typename V::Value) == sizeof(double) ? 2 : 4;

/// The coordinates of a row's atoms, each repeated for all slots of a part.
template <class V, class T>
LJMD_INLINE simd::RawVector<T, V::lanes> of_row(const T* coordinates) {
    constexpr int count = atoms_per_row<V>;
    if constexpr (count == 1) {
        return *coordinates - simd::RawVector<T, V::lanes>{};
    } else {
        simd::RawVector<T, count> numbers;
        __builtin_memcpy(&numbers, coordinates, sizeof numbers);
        return simd::each_repeated<T, V::lanes, count>(numbers);
    }
}

/// The coordinates of a part's slots, repeated for each atom of a row.
template <class V, class T>
LJMD_INLINE simd::RawVector<T, V::lanes> of_part(const T* coordinates) {
    constexpr int count = others_per_row<V>;
    return simd::repeated<T, V::lanes, count>(simd::load_aligned<T, count>(coordinates));
}

/// Separations of the atoms of a row from the atoms of a part.
template <class V>
struct Separation {
    V dx, dy, dz;  ///< r_row - r_part, in the unit of the arithmetic
    V square;      ///< dx^2 + dy^2 + dz^2
};

/// Quantities of pair distances with a long latency (division, root), so that they can be begun ahead.
template <class Arithmetic, bool takes_root>
class PendingDistance {
  public:
    using V = typename Arithmetic::V;

    PendingDistance() = default;
    LJMD_INLINE PendingDistance(const Arithmetic& arithmetic, V square) {
        if constexpr (by_inverse_root) {
            inverse_r_ = inverse_root(arithmetic.in_sigma2(square));
        } else {
            inverse_r2_ = arithmetic.inverse_of(square);
            if constexpr (takes_root) {
                r_ = sqrt(arithmetic.in_sigma2(square));
            }
        }
    }

    /// For two parts at a time.
    LJMD_INLINE static void begin(const Arithmetic& arithmetic, V square, V other_square, PendingDistance (&two)[2]) {
        if constexpr (takes_root) {
            two[0] = PendingDistance(arithmetic, square);
            two[1] = PendingDistance(arithmetic, other_square);
        } else {
            arithmetic.inverses_of(square, other_square, two[0].inverse_r2_, two[1].inverse_r2_);
        }
    }

    /// @param square  as in the constructor  @return r and 1/r only if takes_root
    [[nodiscard]] LJMD_INLINE PairDistance<V> distance(const Arithmetic& arithmetic, V square) const {
        const V r2 = arithmetic.in_sigma2(square);
        if constexpr (by_inverse_root) {
            return {r2, inverse_r_ * inverse_r_, r2 * inverse_r_, inverse_r_};
        } else if constexpr (takes_root) {
            return {r2, inverse_r2_, r_, r_ * inverse_r2_};
        } else {
            return {r2, inverse_r2_, V(0), V(0)};
        }
    }

  private:
    static constexpr bool by_inverse_root = takes_root && V::has_inverse_root;
    V inverse_r2_, r_, inverse_r_;
};

/// Arithmetic in double throughout.
class DoubleArithmetic {
  public:
    using V = simd::Doubles;
    using Coordinate = double;
    /// Coordinate of rows without an atom: out of reach of everything, slots without an atom included.
    static constexpr double nowhere = 1e9;

    explicit DoubleArithmetic(const PairKernelTask& task) : positions_(static_cast<const double*>(task.positions)) {}

    [[nodiscard]] const double* cluster(std::size_t entry) const { return positions_ + entry; }

    /// Move to the row of atoms whose x begin at r.
    LJMD_INLINE void go_to(const double* r) {
        x_ = V(of_row<V>(r));
        y_ = V(of_row<V>(r + to_y));
        z_ = V(of_row<V>(r + to_z));
    }

    LJMD_INLINE Separation<V> separation(std::size_t entry) const {
        const double* r = positions_ + entry;
        const V dx = x_ - V(of_part<V>(r));
        const V dy = y_ - V(of_part<V>(r + to_y));
        const V dz = z_ - V(of_part<V>(r + to_z));
        return {dx, dy, dz, dx * dx + dy * dy + dz * dz};  // rounded as in the scalar sum: pairs at the cutoff agree
    }

    /// Coordinates of a cluster's slots along an axis, relative to a point in the tile [sigma].
    LJMD_INLINE Four places(std::size_t entry, std::ptrdiff_t axis) const {
        const double* along = positions_ + axis * slots;
        return simd::load_aligned<double, slots>(along + entry) - *along;
    }

    /// Length of the unit of dx, dy, dz [sigma].
    [[nodiscard]] double unit() const { return 1.0; }
    /// r^2 and 1/r^2 of a separation.
    LJMD_INLINE V in_sigma2(V square) const { return square; }
    LJMD_INLINE V inverse_of(V square) const { return V(1) / square; }
    LJMD_INLINE void inverses_of(V a, V b, V& inverse_a, V& inverse_b) const {
        reciprocals(a, b, inverse_a, inverse_b);
    }

  private:
    const double* positions_;
    V x_, y_, z_;
};

/// Mixed arithmetic: exact differences of fixed-point positions, pair terms in single precision.
class MixedArithmetic {
  public:
    using V = simd::Floats;
    using Coordinate = std::int32_t;
    static constexpr std::int32_t nowhere = -(1 << 30);

    explicit MixedArithmetic(const PairKernelTask& task)
        : positions_(static_cast<const std::int32_t*>(task.positions)),
          unit_(task.unit),
          unit2_(task.unit * task.unit),
          per_unit2_(1.0 / (task.unit * task.unit)) {}

    [[nodiscard]] const std::int32_t* cluster(std::size_t entry) const { return positions_ + entry; }

    LJMD_INLINE void go_to(const std::int32_t* r) {
        x_ = of_row<V>(r);
        y_ = of_row<V>(r + to_y);
        z_ = of_row<V>(r + to_z);
    }

    LJMD_INLINE Separation<V> separation(std::size_t entry) const {
        const std::int32_t* r = positions_ + entry;
        const V dx(__builtin_convertvector(x_ - of_part<V>(r), V::Raw));
        const V dy(__builtin_convertvector(y_ - of_part<V>(r + to_y), V::Raw));
        const V dz(__builtin_convertvector(z_ - of_part<V>(r + to_z), V::Raw));
        return {dx, dy, dz, multiply_add(dz, dz, multiply_add(dy, dy, dx * dx))};
    }

    LJMD_INLINE Four places(std::size_t entry, std::ptrdiff_t axis) const {
        const std::int32_t* along = positions_ + axis * slots;
        const auto integers = simd::load_aligned<std::int32_t, slots>(along + entry);
        return (__builtin_convertvector(integers, Four) - static_cast<double>(*along)) * unit_;
    }

    // The unit is a power of two, so the bits do not depend on where it is multiplied in. At the division it costs
    // nothing.
    [[nodiscard]] double unit() const { return unit_; }
    LJMD_INLINE V in_sigma2(V square) const { return square * unit2_; }
    LJMD_INLINE V inverse_of(V square) const { return per_unit2_ / square; }
    LJMD_INLINE void inverses_of(V a, V b, V& inverse_a, V& inverse_b) const {
        inverse_a = inverse_of(a);
        inverse_b = inverse_of(b);
    }

  private:
    using Raw = simd::RawVector<std::int32_t, V::lanes>;

    const std::int32_t* positions_;
    double unit_;
    V unit2_;
    V per_unit2_;
    Raw x_, y_, z_;
};

}  // namespace

}  // namespace ljmd
