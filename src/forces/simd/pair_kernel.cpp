// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "pair_kernel.hpp"

#include "cluster_forces.hpp"
#include "ljmd/execution/simd_vector.hpp"
#include "pair_arithmetic.hpp"

namespace ljmd {

namespace {

/// Whether distances to two parts are begun while forces from the previous two are computed. Out-of-order execution
/// covers one or two hundred instructions, too few for the latencies between a separation and a force. Only the
/// 32 registers of AVX-512 suffice for working so far ahead. 16 registers hold the separations of one part beside those
/// of the next.
constexpr bool by_twos = simd::many_registers;

/// Sums over the pairs of a row, lane by lane.
template <class Arithmetic, bool with_energy>
class Sums {
  public:
    using V = typename Arithmetic::V;

    V fx{0}, fy{0}, fz{0};
    V u{0};

    /// @param others  partial forces: x, y and z of minus the forces on the part; the row's contribution is added
    template <class Pair>
    LJMD_INLINE void add(const Arithmetic& arithmetic, const Pair& pair, V cutoff2, const Separation<V>& d,
                         const PendingDistance<Arithmetic, Pair::takes_root>& begun, typename V::Value* others) {
        const auto term = pair(begun.distance(arithmetic, d.square));
        const V w = where_less(d.square, cutoff2, term.w);
        // All are loaded before any is stored. One by one takes a tenth longer.
        constexpr std::size_t axis = partial_forces<V>;
        V x = V::load(others);
        V y = V::load(others + axis);
        V z = V::load(others + 2 * axis);
        add_product(w, d.dx, fx, x);
        add_product(w, d.dy, fy, y);
        add_product(w, d.dz, fz, z);
        x.store(others);
        y.store(others + axis);
        z.store(others + 2 * axis);
        if constexpr (with_energy) {
            u += where_less(d.square, cutoff2, term.u);
        }
    }
};

/// Self-interaction mask: added to the squared distances between a row and the parts of its own cluster, so that of two
/// atoms of a cluster only the earlier one meets the later one, and none meets itself. The number is larger than any
/// squared cutoff, in units of FixedPoint, too.
template <class V>
struct SelfPairMask {
    typename V::Value of_row[rows_per_cluster<V>][parts_per_cluster<V>][V::lanes] = {};
    constexpr SelfPairMask() {
        constexpr std::size_t atoms = atoms_per_row<V>;
        constexpr std::size_t others = others_per_row<V>;
        for (std::size_t atom = 0; atom < slots; ++atom) {
            for (std::size_t other = 0; other <= atom; ++other) {
                of_row[atom / atoms][other / others][atom % atoms * others + other % others] = typename V::Value(1e30);
            }
        }
    }
};

/// Energy and virial of a tile. Each atom of its own and ghost clusters has one position in the tile, so the virial,
/// the sum over pairs of (r_i - r_j)_a f_b, equals the sum over atoms of r_a f_b.
template <class V>
class EnergyAndVirial {
  public:
    /// @param u  energies of a row, by lanes
    LJMD_INLINE void add_row(V u) { u_ += in_double(u); }

    /// @param x, y, z  coordinates of a cluster's slots
    /// @param f        forces on its atoms from all pairs of the tile; 0 for slots without an atom
    LJMD_INLINE void add_cluster(Four x, Four y, Four z, const Four (&f)[3]) {
        xx_ += x * f[0];
        yy_ += y * f[1];
        zz_ += z * f[2];
        xy_ += x * f[1];
        xz_ += x * f[2];
        yz_ += y * f[2];
    }

    [[nodiscard]] PairKernelSums sums() const {
        return {sum(u_),
                {simd::sum_of<slots>(xx_), simd::sum_of<slots>(yy_), simd::sum_of<slots>(zz_), simd::sum_of<slots>(xy_),
                 simd::sum_of<slots>(xz_), simd::sum_of<slots>(yz_)}};
    }

  private:
    decltype(in_double(V())) u_{0};
    Four xx_{}, yy_{}, zz_{}, xy_{}, xz_{}, yz_{};
};

/// The sum over the list of a row of atoms.
template <class Arithmetic, bool with_energy, class Pair>
class Row {
  public:
    using V = typename Arithmetic::V;
    using Real = typename V::Value;

    LJMD_INLINE Row(const Arithmetic& arithmetic, const Pair& pair, V cutoff2, Real* partial,
                    const std::int32_t* entries)
        : arithmetic_(arithmetic), pair_(pair), cutoff2_(cutoff2), partial_(partial), entry_(entries) {}

    /// Meet the row's own cluster, then the entries of its list.
    /// @param own    entry of the cluster, as a whole
    /// @param first  first part of it that has a slot after the row's first atom
    /// @param mask   see SelfPairMask; for that part and the following ones
    /// @param end    end of the list
    LJMD_INLINE void meet_all(std::size_t own, std::size_t first, const Real (*mask)[V::lanes],
                              const std::int32_t* end) {
        if constexpr (by_twos) {
            meet_by_twos(own, first, mask, end);
        } else {
            meet_one_by_one(own, first, mask, end);
        }
    }

    Sums<Arithmetic, with_energy> sums;

  private:
    static constexpr std::size_t width = atoms_per_row<V>;
    static constexpr std::size_t others = others_per_row<V>;
    static constexpr std::size_t parts = parts_per_cluster<V>;
    using Started = PendingDistance<Arithmetic, Pair::takes_root>;

    /// Two parts in progress. No PairDistance here: gcc 12 would need more registers for a second copy of r^2.
    struct Two {
        Separation<V> d[2];
        Started begun[2];
    };

    [[nodiscard]] LJMD_INLINE std::size_t place(std::size_t offset) const {
        return static_cast<std::uint32_t>(entry_[offset]);
    }

    [[nodiscard]] LJMD_INLINE Separation<V> separation_from_own(std::size_t there, const Real* mask) const {
        Separation<V> d = arithmetic_.separation(there);
        d.square += V::load_unaligned(mask);
        return d;
    }

    LJMD_INLINE void meet(const Separation<V>& d, const Started& begun, std::size_t there) {
        sums.add(arithmetic_, pair_, cutoff2_, d, begun, partial_ + there * width);
    }

    /// Meet a part of the row's own cluster. @param mask  see SelfPairMask; for that part
    LJMD_INLINE void meet_own(std::size_t there, const Real* mask) {
        const Separation<V> d = separation_from_own(there, mask);
        meet(d, Started(arithmetic_, d.square), there);
    }

    LJMD_INLINE void meet_one_by_one(std::size_t own, std::size_t first, const Real (*mask)[V::lanes],
                                     const std::int32_t* end) {
        Separation<V> next = arithmetic_.separation(place(0));
        for (std::size_t part = first; part < parts; ++part, ++mask) {
            meet_own(own + part * others, *mask);
        }
        while (entry_ < end) {
            const Separation<V> d = next;
            const std::size_t now = place(0);
            next = arithmetic_.separation(place(1));
            meet(d, Started(arithmetic_, d.square), now);
            ++entry_;
        }
    }

    LJMD_INLINE void meet_by_twos(std::size_t own, std::size_t first, const Real (*mask)[V::lanes],
                                  const std::int32_t* end) {
        static_assert(width > 1, "the last row of single atoms has no part of its own cluster left to begin with");
        for (; first + 1 < parts; ++first, ++mask) {
            meet_own(own + first * others, *mask);
        }
        const std::size_t last_own = own + first * others;
        Two now, next;
        const bool odd = (end - entry_) % 2 != 0;
        now.d[0] = separation_from_own(last_own, *mask);
        if (odd) {  // the first entry of the list goes with the row's own cluster
            now.d[1] = arithmetic_.separation(place(0));
            Started::begin(arithmetic_, now.d[0].square, now.d[1].square, now.begun);
        } else {
            now.begun[0] = Started(arithmetic_, now.d[0].square);
        }
        const std::size_t first_entry = place(0);
        entry_ += odd ? 1 : 0;
        const bool more = entry_ < end;
        if (more) {
            begin(next, 0);
        }
        meet(now.d[0], now.begun[0], last_own);
        if (odd) {
            meet(now.d[1], now.begun[1], first_entry);
        }
        while (more && take_turn(next, now, end) && take_turn(now, next, end)) {
        }
    }

    /// Meet two parts while the next two are begun. `now` and `next` have registers of their own, so nothing is moved.
    /// @return false at the end of the list
    LJMD_INLINE bool take_turn(const Two& now, Two& next, const std::int32_t* end) {
        const bool more = end - entry_ > 2;
        if (more) {
            begin(next, 2);
        }
        meet(now.d[0], now.begun[0], place(0));
        meet(now.d[1], now.begun[1], place(1));
        entry_ += 2;
        return more;
    }

    LJMD_INLINE void begin(Two& two, std::size_t offset) {
        two.d[0] = arithmetic_.separation(place(offset));
        two.d[1] = arithmetic_.separation(place(offset + 1));
        Started::begin(arithmetic_, two.d[0].square, two.d[1].square, two.begun);
    }

    const Arithmetic& arithmetic_;
    const Pair& pair_;
    V cutoff2_;
    Real* partial_;
    const std::int32_t* entry_;
};

/// Sum a tile row by row. Atoms of the tile that have a cluster on their lists come before it, so all their reaction
/// forces have been added when the cluster itself is summed.
template <class Arithmetic, bool with_energy, class Pair>
[[gnu::flatten]] void sum_tile(const void* potential, const PairKernelTask& task, PairKernelSums* sums) {
    using V = typename Arithmetic::V;
    using Real = typename V::Value;
    static constexpr SelfPairMask<V> mask;
    constexpr std::size_t width = atoms_per_row<V>;
    constexpr std::size_t stride = std::size_t{3} * slots;
    const Pair pair = *static_cast<const Pair*>(potential);
    Arithmetic arithmetic(task);
    const V cutoff2(task.cutoff2 / (arithmetic.unit() * arithmetic.unit()));
    EnergyAndVirial<V> total;
    const auto own_clusters = static_cast<std::size_t>(task.own_clusters);
    const auto clusters = static_cast<std::size_t>(task.clusters);
    // Minus the forces on the atoms of a cluster, in separate lanes for each atom of a row. They are set to zero where
    // they are read for the last time, because they lie in the L1 cache then; a pass of its own would cost more.
    auto* const partial = static_cast<Real*>(task.partial_forces);
    constexpr std::size_t axis = partial_forces<V>;
    const std::uint32_t* start = task.starts;
    for (std::size_t cluster = 0; cluster < own_clusters; ++cluster) {
        const std::size_t own = cluster * stride;
        const std::size_t first_atom = task.first_atoms[cluster];
        const std::size_t atoms = task.first_atoms[cluster + 1] - first_atom;
        typename V::Raw sums_of_rows[3][rows_per_cluster<V>];
        if (atoms + width <= slots) {
            __builtin_memset(sums_of_rows, 0, sizeof sums_of_rows);  // some rows have no atom
        }
        for (std::size_t k = 0; k < atoms; k += width, ++start) {
            if (k + width <= atoms) {
                arithmetic.go_to(arithmetic.cluster(own) + k);
            } else {
                typename Arithmetic::Coordinate there[3 * slots];
                for (std::size_t n = 0; n < width; ++n) {
                    for (std::size_t a = 0; a < 3; ++a) {
                        there[a * slots + n] =
                            k + n < atoms ? arithmetic.cluster(own)[a * slots + k + n] : Arithmetic::nowhere;
                    }
                }
                arithmetic.go_to(there);
            }
            Row<Arithmetic, with_energy, Pair> row(arithmetic, pair, cutoff2, partial, task.entries + start[0]);
            // With one part it is always 0. Saying so to the compiler makes AVX2's mixed kernel 4 % faster.
            const std::size_t first = parts_per_cluster<V> == 1 ? 0 : (k + 1) / others_per_row<V>;
            row.meet_all(own, first, mask.of_row[k / width] + first, task.entries + start[1]);
            sums_of_rows[0][k / width] = row.sums.fx.raw;
            sums_of_rows[1][k / width] = row.sums.fy.raw;
            sums_of_rows[2][k / width] = row.sums.fz.raw;
            if constexpr (with_energy) {
                total.add_row(row.sums.u);
            }
        }
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] = (sums_of_atoms<Real>(sums_of_rows[a]) - take_from_others<V>(partial + own * width + a * axis)) *
                       arithmetic.unit();
        }
        if constexpr (with_energy) {
            total.add_cluster(arithmetic.places(own, 0), arithmetic.places(own, 1), arithmetic.places(own, 2), force);
        }
        write_forces<vector_stride>(force, atoms, task.forces + vector_stride * first_atom);
    }
    for (std::size_t cluster = own_clusters; cluster < clusters; ++cluster) {
        const std::size_t ghost = cluster * stride;
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] = take_from_others<V>(partial + ghost * width + a * axis) * -arithmetic.unit();
        }
        write_forces<3>(force, slots, task.ghost_forces + (ghost - own_clusters * stride));
        if constexpr (with_energy) {
            total.add_cluster(arithmetic.places(ghost, 0), arithmetic.places(ghost, 1), arithmetic.places(ghost, 2),
                              force);
        }
    }
    if constexpr (with_energy) {
        *sums = total.sums();
    }
}

template <class Arithmetic, class... Pairs>
constexpr PairKernelsOfPotentials kernels_for(const std::variant<Pairs...>*) {
    return {{{{&sum_tile<Arithmetic, false, Pairs>, &sum_tile<Arithmetic, true, Pairs>}}...}};
}

template <class V>
constexpr RowShape row_shape{atoms_per_row<V>, others_per_row<V>};

constexpr PairKernels kernels{{row_shape<DoubleArithmetic::V>, row_shape<MixedArithmetic::V>},
                              {kernels_for<DoubleArithmetic>(static_cast<const AnyPair*>(nullptr)),
                               kernels_for<MixedArithmetic>(static_cast<const AnyPair*>(nullptr))}};

}  // namespace

template <>
const PairKernels* simd::compiled_here<const PairKernels*, simd::Here>() {
    return &kernels;
}

}  // namespace ljmd
