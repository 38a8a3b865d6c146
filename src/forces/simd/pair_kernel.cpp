// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "pair_kernel.hpp"

#include "ljmd/core/simd_vector.hpp"

namespace ljmd {

namespace {

constexpr int slots = ClusterGrid::slots;
using Four = simd::RawVector<double, slots>;

/// From the x of a cluster's slots to their y and z.
constexpr std::ptrdiff_t to_y = slots;
constexpr std::ptrdiff_t to_z = std::ptrdiff_t{2} * slots;

/// A row of atoms meets a cluster: lane 4 n + k is for the row's atom n and the cluster's slot k.
template <class V>
constexpr int atoms_per_row = V::lanes / slots;
template <class V>
constexpr int rows_per_cluster = slots / atoms_per_row<V>;

/// How many clusters ahead of the one whose forces are worked out separations and divisions are begun. A processor
/// looks at the next hundred or two of instructions for what can be done while others wait, which is less than the
/// latencies from a separation to a force ask for. So far ahead only the 32 registers of AVX-512 reach; 16 hold the
/// separations from one cluster beside those from the next.
template <class V>
constexpr std::size_t lead = sizeof(typename V::Raw) == 64 ? 3 : 0;

/// Each of the numbers in four lanes.
template <class T, int lanes>
LJMD_INLINE simd::RawVector<T, lanes> in_four_lanes(const T* numbers) {
    if constexpr (lanes == 4) {
        return *numbers - simd::RawVector<T, lanes>{};
    } else {
        return simd::joined<T, lanes / 2>(in_four_lanes<T, lanes / 2>(numbers),
                                          in_four_lanes<T, lanes / 2>(numbers + lanes / 8));
    }
}

/// Four numbers over and over.
template <class T, int lanes>
LJMD_INLINE simd::RawVector<T, lanes> repeated(const T* numbers) {
    return simd::repeated<T, lanes>(simd::load_aligned<T, 4>(numbers));
}

/// Separations of the atoms of a row from those of a cluster.
template <class V>
struct Separation {
    V dx, dy, dz;  ///< in the arithmetic's unit
    V r2;          ///< [sigma^2]
};

/// Everything in double.
class DoubleArithmetic {
  public:
    using V = simd::Doubles;
    using Coordinate = double;
    /// Out of reach of everything, the slots without an atom included.
    static constexpr double nowhere = 1e9;

    explicit DoubleArithmetic(const PairKernelTask& task) : positions_(static_cast<const double*>(task.positions)) {}

    [[nodiscard]] const double* cluster(std::size_t entry) const { return positions_ + entry; }

    /// To the atoms whose x begin at r.
    LJMD_INLINE void go_to(const double* r) {
        x_ = V(in_four_lanes<double, V::lanes>(r));
        y_ = V(in_four_lanes<double, V::lanes>(r + to_y));
        z_ = V(in_four_lanes<double, V::lanes>(r + to_z));
    }

    LJMD_INLINE Separation<V> separation(std::size_t entry) const {
        const double* r = positions_ + entry;
        const V dx = x_ - V(repeated<double, V::lanes>(r));
        const V dy = y_ - V(repeated<double, V::lanes>(r + to_y));
        const V dz = z_ - V(repeated<double, V::lanes>(r + to_z));
        return {dx, dy, dz, dx * dx + dy * dy + dz * dz};  // rounded as the scalar sum does, see docs/performance.md
    }

    /// Along an axis, the places of a cluster's slots, from a point in the tile [sigma].
    LJMD_INLINE Four places(std::size_t entry, std::ptrdiff_t axis) const {
        const double* along = positions_ + axis * slots;
        return simd::load_aligned<double, slots>(along + entry) - *along;
    }

    /// What dx = 1 means [sigma].
    [[nodiscard]] double unit() const { return 1.0; }

  private:
    const double* positions_;
    V x_, y_, z_;
};

/// Exact differences of fixed-point positions, pair terms in single precision.
class MixedArithmetic {
  public:
    using V = simd::Floats;
    using Coordinate = std::int32_t;
    static constexpr std::int32_t nowhere = -(1 << 30);

    explicit MixedArithmetic(const PairKernelTask& task)
        : positions_(static_cast<const std::int32_t*>(task.positions)),
          unit_(task.unit),
          unit2_(task.unit * task.unit) {}

    [[nodiscard]] const std::int32_t* cluster(std::size_t entry) const { return positions_ + entry; }

    LJMD_INLINE void go_to(const std::int32_t* r) {
        x_ = in_four_lanes<std::int32_t, V::lanes>(r);
        y_ = in_four_lanes<std::int32_t, V::lanes>(r + to_y);
        z_ = in_four_lanes<std::int32_t, V::lanes>(r + to_z);
    }

    LJMD_INLINE Separation<V> separation(std::size_t entry) const {
        const std::int32_t* r = positions_ + entry;
        const V dx(__builtin_convertvector(x_ - repeated<std::int32_t, V::lanes>(r), V::Raw));
        const V dy(__builtin_convertvector(y_ - repeated<std::int32_t, V::lanes>(r + to_y), V::Raw));
        const V dz(__builtin_convertvector(z_ - repeated<std::int32_t, V::lanes>(r + to_z), V::Raw));
        return {dx, dy, dz, multiply_add(dz, dz, multiply_add(dy, dy, dx * dx)) * unit2_};
    }

    LJMD_INLINE Four places(std::size_t entry, std::ptrdiff_t axis) const {
        const std::int32_t* along = positions_ + axis * slots;
        const auto integers = simd::load_aligned<std::int32_t, slots>(along + entry);
        return (__builtin_convertvector(integers, Four) - static_cast<double>(*along)) * unit_;
    }

    [[nodiscard]] double unit() const { return unit_; }

  private:
    using Raw = simd::RawVector<std::int32_t, V::lanes>;

    const std::int32_t* positions_;
    double unit_;
    V unit2_;
    Raw x_, y_, z_;
};

/// Sums over the pairs of a row, by lanes.
template <class V, bool with_energy>
class Sums {
  public:
    V fx{0}, fy{0}, fz{0};
    V u{0};

    /// @param others  x, y and z of minus the forces on the cluster that is met, which grow, too
    template <class Pair>
    LJMD_INLINE void add(const Pair& pair, V cutoff2, const Separation<V>& d, V inverse_r2, typename V::Value* others) {
        const auto term = pair(d.r2, inverse_r2);
        const V w = where_less(d.r2, cutoff2, term.w);
        // Added to both sides, not fused: processors add and multiply at the same time, by different units.
        const V wx = w * d.dx;
        const V wy = w * d.dy;
        const V wz = w * d.dz;
        fx += wx;
        fy += wy;
        fz += wz;
        // All are read before any is written. One by one would take a tenth longer.
        constexpr std::size_t axis = V::lanes;
        const V x = V::load(others) + wx;
        const V y = V::load(others + axis) + wy;
        const V z = V::load(others + 2 * axis) + wz;
        x.store(others);
        y.store(others + axis);
        z.store(others + 2 * axis);
        if constexpr (with_energy) {
            u += where_less(d.r2, cutoff2, term.u);
        }
    }
};

/// What to add to the squared distances of each row of a cluster from the cluster itself, so that of two of its atoms
/// only the one before meets the other, and none itself.
template <class V>
struct Aside {
    static constexpr std::size_t rows = rows_per_cluster<V>;
    typename V::Value of_row[rows][V::lanes] = {};
    constexpr Aside() {
        for (std::size_t atom = 0; atom < slots; ++atom) {
            const std::size_t in_row = atom % (slots / rows);
            for (std::size_t other = 0; other <= atom; ++other) {
                of_row[atom / (slots / rows)][in_row * slots + other] = typename V::Value(1e15);
            }
        }
    }
};

/// Four numbers in double.
LJMD_INLINE Four in_double(Four x) {
    return x;
}
LJMD_INLINE Four in_double(simd::RawVector<float, slots> x) {
    return simd::widened<slots>(x);
}

/// What the rows of a cluster sum up to, atom by atom. @param rows  of each row its sums, by lanes
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 4> (&rows)[4]) {
    const auto [a, b, c, d] = rows;
    const auto ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const auto cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return in_double(__builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
}
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 8> (&rows)[2]) {
    const auto [a, b] = rows;
    const auto ab = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
                    __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    return in_double(__builtin_shufflevector(ab, ab, 0, 4, 1, 5) + __builtin_shufflevector(ab, ab, 2, 6, 3, 7));
}
template <class T>
LJMD_INLINE Four sums_of_atoms(const simd::RawVector<T, 16> (&rows)[1]) {
    const auto a = rows[0];
    const auto twos = a + __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14);
    return in_double(__builtin_shufflevector(twos, twos, 0, 4, 8, 12) +
                     __builtin_shufflevector(twos, twos, 2, 6, 10, 14));
}

/// Of four-lane pieces their sum.
template <class T, int lanes>
LJMD_INLINE simd::RawVector<T, slots> sum_of_pieces(simd::RawVector<T, lanes> v) {
    if constexpr (lanes == slots) {
        return v;
    } else {
        return sum_of_pieces<T, lanes / 2>(simd::low_half<T, lanes>(v) + simd::high_half<T, lanes>(v));
    }
}

/// Energy and virial of a tile. The pairs of a tile are those among its clusters and guests, all of which have one
/// place in it, so what pairs add to the virial, (r_i - r_j)_a f_b, is r_a f_b summed over atoms instead.
template <class V>
class EnergyAndVirial {
  public:
    /// @param u  of a row, by lanes
    LJMD_INLINE void add_row(V u) { u_ += in_double(u); }

    /// @param x, y, z  places of a cluster's slots
    /// @param f        on its atoms from all of the tile; none where there is no atom
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

/// Along one axis, minus the forces of rows before on a cluster. @param others  of each row's atom in lanes of its own
template <class V>
LJMD_INLINE Four from_others(const typename V::Value* others) {
    return in_double(sum_of_pieces<typename V::Value, V::lanes>(V::load(others).raw));
}

/// A row of atoms on its way along its list.
template <class Arithmetic, bool with_energy, class Pair>
class Row {
  public:
    using V = typename Arithmetic::V;
    using Real = typename V::Value;

    LJMD_INLINE Row(const Arithmetic& arithmetic, const Pair& pair, V cutoff2, Real* partial,
                    const std::int32_t* entries)
        : arithmetic_(arithmetic), pair_(pair), cutoff2_(cutoff2), partial_(partial), entry_(entries) {}

    /// Meet the row's own cluster, then those on its list.
    /// @param own    the place of the first
    /// @param aside  see Aside
    /// @param end    of the list
    LJMD_INLINE void meet_all(std::size_t own, const Real* aside, const std::int32_t* end) {
        const bool far_ahead = lead<V> > 0 && end - entry_ >= static_cast<std::ptrdiff_t>(lead<V>);
        Separation<V> next;
        if (far_ahead) {
            look_ahead(std::make_index_sequence<lead<V>>());
        } else {
            next = arithmetic_.separation(place(0));
        }
        Separation<V> d = arithmetic_.separation(own);
        d.r2 += V::load_unaligned(aside);
        meet(d, V(1) / d.r2, own);
        if (far_ahead) {
            while (take_turns(end, std::make_index_sequence<lead<V> + 1>())) {
            }
            return;
        }
        while (entry_ < end) {
            d = next;
            const std::size_t now = place(0);
            next = arithmetic_.separation(place(1));
            meet(d, V(1) / d.r2, now);
            ++entry_;
        }
    }

    Sums<V, with_energy> sums;

  private:
    static constexpr std::size_t width = atoms_per_row<V>;

    [[nodiscard]] LJMD_INLINE std::size_t place(std::size_t offset) const {
        return static_cast<std::uint32_t>(entry_[offset]);
    }

    LJMD_INLINE void meet(const Separation<V>& d, V inverse_r2, std::size_t there) {
        sums.add(pair_, cutoff2_, d, inverse_r2, partial_ + there * width);
    }

    /// Begin what there is to do with the entry so many behind the present one.
    LJMD_INLINE void look(std::size_t slot, std::size_t offset) {
        ahead_[slot].d = arithmetic_.separation(place(offset));
        ahead_[slot].inverse_r2 = V(1) / ahead_[slot].d.r2;
    }
    template <std::size_t... offset>
    LJMD_INLINE void look_ahead(std::index_sequence<offset...>) {
        (look(offset, offset), ...);
    }

    /// Each of what is under way has its turn in registers of its own: none is moved. @return false at the end
    template <std::size_t... slot>
    LJMD_INLINE bool take_turns(const std::int32_t* end, std::index_sequence<slot...>) {
        return (take_turn<slot>(end) && ...);
    }
    template <std::size_t slot>
    LJMD_INLINE bool take_turn(const std::int32_t* end) {
        if (entry_ + lead<V> == end) {
            meet_last<slot>(std::make_index_sequence<lead<V>>());
            return false;
        }
        look((slot + lead<V>) % (lead<V> + 1), lead<V>);
        meet(ahead_[slot].d, ahead_[slot].inverse_r2, place(0));
        ++entry_;
        return true;
    }
    template <std::size_t slot, std::size_t... offset>
    LJMD_INLINE void meet_last(std::index_sequence<offset...>) {
        (meet(ahead_[(slot + offset) % (lead<V> + 1)].d, ahead_[(slot + offset) % (lead<V> + 1)].inverse_r2,
              place(offset)),
         ...);
    }

    struct Ahead {
        Separation<V> d;
        V inverse_r2;
    };

    const Arithmetic& arithmetic_;
    const Pair& pair_;
    V cutoff2_;
    Real* partial_;
    const std::int32_t* entry_;
    Ahead ahead_[lead<V> + 1];
};

/// Write the forces on the atoms of a cluster, x y z 0 each. @param f  by axes
LJMD_INLINE void write_forces(const Four (&f)[3], std::size_t atoms, double* to) {
    const Four none{};
    const Four xy01 = __builtin_shufflevector(f[0], f[1], 0, 4, 1, 5);
    const Four xy23 = __builtin_shufflevector(f[0], f[1], 2, 6, 3, 7);
    const Four z01 = __builtin_shufflevector(f[2], none, 0, 4, 1, 5);
    const Four z23 = __builtin_shufflevector(f[2], none, 2, 6, 3, 7);
    const auto write = [&](std::size_t k, Four of_atom) {
        if (k < atoms) {
            __builtin_memcpy(to + slots * k, &of_atom, sizeof of_atom);
        }
    };
    write(0, __builtin_shufflevector(xy01, z01, 0, 1, 4, 5));
    write(1, __builtin_shufflevector(xy01, z01, 2, 3, 6, 7));
    write(2, __builtin_shufflevector(xy23, z23, 0, 1, 4, 5));
    write(3, __builtin_shufflevector(xy23, z23, 2, 3, 6, 7));
}

/// Row by row. When a cluster's turn comes, all atoms of the tile that have pairs with it on their lists have had
/// theirs.
template <class Arithmetic, bool with_energy, class Pair>
[[gnu::flatten]] void sum_tile(const void* potential, const PairKernelTask& task, PairKernelSums* sums) {
    using V = typename Arithmetic::V;
    using Real = typename V::Value;
    static constexpr Aside<V> aside;
    constexpr std::size_t width = atoms_per_row<V>;
    constexpr std::size_t stride = std::size_t{3} * slots;
    const Pair pair = *static_cast<const Pair*>(potential);
    const V cutoff2(task.cutoff2);
    Arithmetic arithmetic(task);
    EnergyAndVirial<V> total;
    const auto own_clusters = static_cast<std::size_t>(task.own_clusters);
    const auto clusters = static_cast<std::size_t>(task.clusters);
    // Minus the forces on the atoms of a cluster, of each row's atom in lanes of its own.
    auto* const partial = static_cast<Real*>(task.partial_forces);
    for (std::size_t k = 0; k < clusters * 3; ++k) {
        V(0).store(partial + k * V::lanes);
    }
    constexpr std::size_t axis = V::lanes;
    const std::uint32_t* start = task.starts;
    for (std::size_t cluster = 0; cluster < own_clusters; ++cluster) {
        const std::size_t own = cluster * stride;
        const std::size_t first_atom = task.first_atoms[cluster];
        const std::size_t atoms = task.first_atoms[cluster + 1] - first_atom;
        typename V::Raw sums_of_rows[3][rows_per_cluster<V>];
        if (atoms + width <= slots) {
            __builtin_memset(sums_of_rows, 0, sizeof sums_of_rows);  // rows without an atom
        }
        for (std::size_t k = 0; k < atoms; k += width, ++start) {
            if (width == 1 || k + width <= atoms) {
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
            row.meet_all(own, aside.of_row[k / width], task.entries + start[1]);
            sums_of_rows[0][k / width] = row.sums.fx.raw;
            sums_of_rows[1][k / width] = row.sums.fy.raw;
            sums_of_rows[2][k / width] = row.sums.fz.raw;
            if constexpr (with_energy) {
                total.add_row(row.sums.u);
            }
        }
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] = (sums_of_atoms<Real>(sums_of_rows[a]) - from_others<V>(partial + own * width + a * axis)) *
                       arithmetic.unit();
        }
        if constexpr (with_energy) {
            total.add_cluster(arithmetic.places(own, 0), arithmetic.places(own, 1), arithmetic.places(own, 2), force);
        }
        write_forces(force, atoms, task.forces + slots * first_atom);
    }
    for (std::size_t cluster = own_clusters; cluster < clusters; ++cluster) {
        const std::size_t guest = cluster * stride;
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] = from_others<V>(partial + guest * width + a * axis) * -arithmetic.unit();
        }
        __builtin_memcpy(task.guest_forces + (guest - own_clusters * stride), force, sizeof force);
        if constexpr (with_energy) {
            total.add_cluster(arithmetic.places(guest, 0), arithmetic.places(guest, 1), arithmetic.places(guest, 2),
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

constexpr PairKernels kernels{{atoms_per_row<DoubleArithmetic::V>, atoms_per_row<MixedArithmetic::V>},
                              {kernels_for<DoubleArithmetic>(static_cast<const AnyPair*>(nullptr)),
                               kernels_for<MixedArithmetic>(static_cast<const AnyPair*>(nullptr))}};

}  // namespace

template <>
const PairKernels* simd::compiled_here<const PairKernels*, simd::Here>() {
    return &kernels;
}

}  // namespace ljmd
