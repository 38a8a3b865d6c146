// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "forces/simd/pair_kernel.hpp"

#include "execution/simd_vector.hpp"
#include "forces/simd/cluster_forces.hpp"
#include "forces/simd/energy_and_virial.hpp"
#include "forces/simd/pair_arithmetic.hpp"

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
/// squared cutoff, in units of FixedPoint, too. It is needed for the part that the row itself lies in; earlier parts of
/// its cluster are not met, later ones like parts of other clusters.
template <class V>
struct SelfPairMask {
    typename V::Value of_row[rows_per_cluster<V>][V::lanes] = {};
    constexpr SelfPairMask() {
        constexpr std::size_t atoms = atoms_per_row<V>;
        constexpr std::size_t others = others_per_row<V>;
        for (std::size_t atom = 0; atom < slots; ++atom) {
            for (std::size_t other = atom / others * others; other <= atom; ++other) {
                of_row[atom / atoms][atom % atoms * others + other % others] = typename V::Value(1e30);
            }
        }
    }
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

    /// Meet the part that the row lies in and the parts in the first half of its list, then the parts in the second
    /// half. So each half of the slots of clusters has sums of its own, as each slot has where parts are whole
    /// clusters.
    /// @param own     entry of the part that the row lies in
    /// @param mask    see SelfPairMask
    /// @param middle  where the second half of the list begins: at its end for parts that are whole clusters
    /// @param end     of the list
    LJMD_INLINE void meet_all(std::size_t own, const Real* mask, const std::int32_t* middle, const std::int32_t* end) {
        if constexpr (by_twos) {
            meet_by_twos(own, mask, middle, end);
        } else {
            meet_one_by_one(own, mask, middle, end);
        }
    }

    Sums<Arithmetic, with_energy> sums;        ///< over the half of the slots that was met last
    Sums<Arithmetic, with_energy> first_sums;  ///< over the other half, if there are two

  private:
    static constexpr std::size_t reacting = reaction_atoms<V>;
    static constexpr bool has_halves = parts_per_cluster<V> == 2;
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
        sums.add(arithmetic_, pair_, cutoff2_, d, begun, partial_ + there * reacting);
    }

    LJMD_INLINE void end_first_half() {
        first_sums = sums;
        sums = {};
    }

    LJMD_INLINE void meet_one_by_one(std::size_t own, const Real* mask, const std::int32_t* middle,
                                     const std::int32_t* end) {
        Separation<V> next = arithmetic_.separation(place(0));
        const Separation<V> d = separation_from_own(own, mask);
        meet(d, Started(arithmetic_, d.square), own);
        meet_until(middle, next);
        if constexpr (has_halves) {
            end_first_half();
            meet_until(end, next);
        }
    }

    LJMD_INLINE void meet_until(const std::int32_t* end, Separation<V>& next) {
        while (entry_ < end) {
            const Separation<V> d = next;
            const std::size_t now = place(0);
            next = arithmetic_.separation(place(1));
            meet(d, Started(arithmetic_, d.square), now);
            ++entry_;
        }
    }

    LJMD_INLINE void meet_by_twos(std::size_t own, const Real* mask, const std::int32_t* middle,
                                  const std::int32_t* end) {
        Two now, next;
        const bool odd = (middle - entry_) % 2 != 0;
        now.d[0] = separation_from_own(own, mask);
        if (odd) {  // the first entry of the list goes with the row's own part
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
        meet(now.d[0], now.begun[0], own);
        if (odd) {
            meet(now.d[1], now.begun[1], first_entry);
        }
        if constexpr (has_halves) {
            while (entry_ < middle) {
                take_turn(next, now, end);
                if (entry_ == middle) {
                    next = now;
                    break;
                }
                take_turn(now, next, end);
            }
            end_first_half();
            while (end - entry_ > 1) {
                take_turn(next, now, end);
                if (end - entry_ <= 1) {
                    next = now;
                    break;
                }
                take_turn(now, next, end);
            }
            if (entry_ < end) {
                meet(next.d[0], next.begun[0], place(0));
            }
        } else {
            while (more && take_turn(next, now, end) && take_turn(now, next, end)) {
            }
        }
    }

    /// Meet two parts while the next two are begun. `now` and `next` have registers of their own, so nothing is moved.
    /// @return false at the end of the list. Of an odd number the last one is begun with what follows the list.
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
    constexpr std::size_t others = others_per_row<V>;
    constexpr std::size_t parts = parts_per_cluster<V>;
    constexpr std::size_t reacting = reaction_atoms<V>;
    constexpr std::size_t stride = std::size_t{3} * slots;
    const Pair pair = *static_cast<const Pair*>(potential);
    Arithmetic arithmetic(task);
    const V cutoff2(task.cutoff2 / (arithmetic.unit() * arithmetic.unit()));
    EnergySum<V> energy;
    VirialSum virial;
    const auto own_clusters = static_cast<std::size_t>(task.own_clusters);
    const auto clusters = static_cast<std::size_t>(task.clusters);
    // Minus the forces on the atoms of a cluster, in separate lanes for reacting atoms. They are set to zero where they
    // are read for the last time, because they lie in the L1 cache then; a pass of its own would cost more.
    auto* const partial = static_cast<Real*>(task.partial_forces);
    constexpr std::size_t axis = partial_forces<V>;
    const std::uint32_t* start = task.starts;
    for (std::size_t cluster = 0; cluster < own_clusters; ++cluster) {
        const std::size_t own = cluster * stride;
        const std::size_t first_atom = task.first_atoms[cluster];
        const std::size_t atoms = task.first_atoms[cluster + 1] - first_atom;
        typename V::Raw sums_of_rows[3][parts][rows_per_cluster<V>];
        typename EnergySum<V>::Rows energies;
        if (atoms + width <= slots) {  // some rows have no atom
            __builtin_memset(sums_of_rows, 0, sizeof sums_of_rows);
            if constexpr (with_energy) {
                __builtin_memset(energies, 0, sizeof energies);
            }
        }
        for (std::size_t k = 0; k < atoms; k += width, start += parts) {
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
            // With one part it is always 0. Saying so to the compiler makes AVX2's mixed kernel 4 % faster.
            const std::size_t part = parts == 1 ? 0 : k / others;
            Row<Arithmetic, with_energy, Pair> row(arithmetic, pair, cutoff2, partial + k % reacting * others,
                                                   task.entries + start[0]);
            row.meet_all(own + part * others, mask.of_row[k / width], task.entries + start[1],
                         task.entries + start[parts]);
            const auto keep = [&](const auto& of_row, std::size_t of_part) {
                sums_of_rows[0][of_part][k / width] = of_row.fx.raw;
                sums_of_rows[1][of_part][k / width] = of_row.fy.raw;
                sums_of_rows[2][of_part][k / width] = of_row.fz.raw;
                if constexpr (with_energy) {
                    energies[of_part][k / width] = of_row.u.raw;
                }
            };
            if constexpr (parts == 1) {
                keep(row.sums, 0);
            } else {
                keep(row.first_sums, part);
                keep(row.sums, 1 - part);
            }
        }
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] =
                (sums_of_atoms<Real>(sums_of_rows[a]) - take_from_others<V>(partial + own * reacting + a * axis)) *
                arithmetic.unit();
        }
        if constexpr (with_energy) {
            energy.add_cluster(energies);
            virial.add_cluster(arithmetic.places(own, 0), arithmetic.places(own, 1), arithmetic.places(own, 2), force);
        }
        write_forces<vector_stride>(force, atoms, task.forces + vector_stride * first_atom);
    }
    for (std::size_t cluster = own_clusters; cluster < clusters; ++cluster) {
        const std::size_t ghost = cluster * stride;
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] = take_from_others<V>(partial + ghost * reacting + a * axis) * -arithmetic.unit();
        }
        write_forces<3>(force, slots, task.ghost_forces + (ghost - own_clusters * stride));
        if constexpr (with_energy) {
            virial.add_cluster(arithmetic.places(ghost, 0), arithmetic.places(ghost, 1), arithmetic.places(ghost, 2),
                               force);
        }
    }
    if constexpr (with_energy) {
        *sums = {energy.value(), virial.value()};
    }
}

template <class Arithmetic, class... Pairs>
constexpr PairKernelsOfPotentials kernels_for(const std::variant<Pairs...>*) {
    return {{{{&sum_tile<Arithmetic, false, Pairs>, &sum_tile<Arithmetic, true, Pairs>}}...}};
}

template <class V>
constexpr RowShape row_shape{atoms_per_row<V>, others_per_row<V>};

constexpr PairKernels kernels{{row_shape<DoubleArithmetic::V>, row_shape<MixedArithmetic::V>},
                              {3 * partial_forces<DoubleArithmetic::V>, 3 * partial_forces<MixedArithmetic::V>},
                              {kernels_for<DoubleArithmetic>(static_cast<const AnyPair*>(nullptr)),
                               kernels_for<MixedArithmetic>(static_cast<const AnyPair*>(nullptr))}};

}  // namespace

template <>
const PairKernels* simd::compiled_here<const PairKernels*, simd::Here>() {
    return &kernels;
}

}  // namespace ljmd
