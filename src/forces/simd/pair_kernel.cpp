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

/// A row of atoms meets a cluster: lane 4 n + k is for the row's atom n and the cluster's slot k. A vector of two lanes
/// meets it in two pieces, one after the other.
template <class V>
constexpr int atoms_per_row = V::lanes < slots ? 1 : V::lanes / slots;
template <class V>
constexpr std::size_t pieces = V::lanes < slots ? slots / V::lanes : 1;

/// Each of the numbers in four lanes, or one in all.
template <class T, int lanes>
LJMD_INLINE simd::RawVector<T, lanes> in_four_lanes(const T* numbers) {
    if constexpr (lanes <= 4) {
        return *numbers - simd::RawVector<T, lanes>{};
    } else {
        return simd::joined<T, lanes / 2>(in_four_lanes<T, lanes / 2>(numbers),
                                          in_four_lanes<T, lanes / 2>(numbers + lanes / 8));
    }
}

/// Four numbers over and over, or as many of them as there are lanes.
template <class T, int lanes>
LJMD_INLINE simd::RawVector<T, lanes> repeated(const T* numbers) {
    if constexpr (lanes <= 4) {
        return simd::load_aligned<T, lanes>(numbers);
    } else {
        return simd::repeated<T, lanes>(simd::load_aligned<T, 4>(numbers));
    }
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
        constexpr std::size_t axis = V::lanes * pieces<V>;
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
    static constexpr std::size_t rows = slots / atoms_per_row<V>;
    static constexpr std::size_t numbers = V::lanes * pieces<V>;
    typename V::Value of_row[rows][numbers] = {};
    constexpr Aside() {
        for (std::size_t atom = 0; atom < slots; ++atom) {
            const std::size_t in_row = atom % (slots / rows);
            for (std::size_t other = 0; other <= atom; ++other) {
                of_row[atom / (slots / rows)][in_row * slots + other] = typename V::Value(1e15);
            }
        }
    }
};

/// The sums of four vectors over their lanes.
LJMD_INLINE Four sums_of_four(Four a, Four b, Four c, Four d) {
    const Four ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Four cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// The part of a row's sums that is its atom n's.
template <int n, class V>
LJMD_INLINE Four of_atom(V sums) {
    if constexpr (V::lanes < slots) {
        return simd::joined<double, V::lanes>(sums.raw, typename V::Raw{});
    } else if constexpr (std::is_same_v<typename V::Value, double>) {
        return simd::four_lanes<n, double, V::lanes>(sums.raw);
    } else {
        return simd::widened<slots>(simd::four_lanes<n, float, V::lanes>(sums.raw));
    }
}

/// What the rows of a cluster sum up to, atom by atom.
class ForcesOfCluster {
  public:
    LJMD_INLINE void reset() {
        for (auto& atom : sums_) {
            atom[0] = atom[1] = atom[2] = Four{};
        }
    }

    template <int n = 0, class Sums>
    LJMD_INLINE void keep(int first, const Sums& row) {
        using V = decltype(row.fx);
        if constexpr (n < atoms_per_row<V>) {
            Four* atom = sums_[first + n];
            atom[0] = of_atom<n>(row.fx);
            atom[1] = of_atom<n>(row.fy);
            atom[2] = of_atom<n>(row.fz);
            keep<n + 1>(first, row);
        }
    }

    [[nodiscard]] LJMD_INLINE Four along(int axis) const {
        return sums_of_four(sums_[0][axis], sums_[1][axis], sums_[2][axis], sums_[3][axis]);
    }

  private:
    Four sums_[slots][3];
};

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
    Four sum{};
    for (int m = 0; m < atoms_per_row<V>; ++m) {
        const auto part = simd::load_aligned<typename V::Value, slots>(others + std::ptrdiff_t{m} * slots);
        if constexpr (std::is_same_v<typename V::Value, double>) {
            sum += part;
        } else {
            sum += simd::widened<slots>(part);
        }
    }
    return sum;
}

/// Row by row: its own cluster, then those on its list. When a cluster's turn comes, all atoms of the tile that have
/// pairs with it on their lists have had theirs.
template <class Arithmetic, bool with_energy, class Pair>
[[gnu::flatten]] void sum_tile(const void* potential, const PairKernelTask& task, PairKernelSums* sums) {
    using V = typename Arithmetic::V;
    using Real = typename V::Value;
    static constexpr Aside<V> aside;
    constexpr int width = atoms_per_row<V>;
    constexpr std::size_t stride = std::size_t{3} * slots;
    const Pair pair = *static_cast<const Pair*>(potential);
    const V cutoff2(task.cutoff2);
    Arithmetic arithmetic(task);
    EnergyAndVirial<V> total;
    const auto own_clusters = static_cast<std::size_t>(task.own_clusters);
    const auto clusters = static_cast<std::size_t>(task.clusters);
    // Minus the forces on the atoms of a cluster, of each row's atom in lanes of its own.
    auto* const partial = static_cast<Real*>(task.partial_forces);
    for (std::size_t k = 0; k < clusters * 3 * pieces<V>; ++k) {
        V(0).store(partial + k * V::lanes);
    }
    constexpr std::size_t axis = V::lanes * pieces<V>;
    const std::int32_t* const entries = task.entries;
    const auto place = [entries](std::size_t n) {
        return static_cast<std::uint32_t>(entries[n / pieces<V>]) + n % pieces<V> * V::lanes;
    };
    const std::uint32_t* row = task.starts;
    ForcesOfCluster forces;
    for (std::size_t cluster = 0; cluster < own_clusters; ++cluster) {
        const std::size_t own = cluster * stride;
        const std::uint32_t first_atom = task.first_atoms[cluster];
        const int atoms = static_cast<int>(task.first_atoms[cluster + 1] - first_atom);
        forces.reset();
        for (int k = 0; k < atoms; k += width, ++row) {
            if (width == 1 || k + width <= atoms) {
                arithmetic.go_to(arithmetic.cluster(own) + k);
            } else {
                typename Arithmetic::Coordinate there[3 * slots];
                for (int n = 0; n < width; ++n) {
                    for (int a = 0; a < 3; ++a) {
                        there[a * slots + n] =
                            k + n < atoms ? arithmetic.cluster(own)[a * slots + k + n] : Arithmetic::nowhere;
                    }
                }
                arithmetic.go_to(there);
            }
            Sums<V, with_energy> sum_of_row;
            // The separations from the next cluster are on their way while the forces of one are worked out.
            std::size_t n = row[0] * pieces<V>;
            const std::size_t end = row[1] * pieces<V>;
            std::size_t next_place = place(n);
            Separation<V> next = arithmetic.separation(next_place);
            for (std::size_t p = 0; p < pieces<V>; ++p) {
                const std::size_t now = own + p * V::lanes;
                Separation<V> d = arithmetic.separation(now);
                d.r2 += V::load_unaligned(aside.of_row[k / width] + p * V::lanes);
                sum_of_row.add(pair, cutoff2, d, V(1) / d.r2, partial + now * width);
            }
            while (n < end) {
                const std::size_t now = next_place;
                const Separation<V> d = next;
                next_place = place(++n);
                next = arithmetic.separation(next_place);
                sum_of_row.add(pair, cutoff2, d, V(1) / d.r2, partial + now * width);
            }
            forces.keep(k, sum_of_row);
            if constexpr (with_energy) {
                total.add_row(sum_of_row.u);
            }
        }
        Four force[3];
        for (std::size_t a = 0; a < 3; ++a) {
            force[a] = (forces.along(static_cast<int>(a)) - from_others<V>(partial + own * width + a * axis)) *
                       arithmetic.unit();
        }
        if constexpr (with_energy) {
            total.add_cluster(arithmetic.places(own, 0), arithmetic.places(own, 1), arithmetic.places(own, 2), force);
        }
        for (int k = 0; k < atoms; ++k) {
            double* to = task.forces + 4 * (first_atom + static_cast<std::size_t>(k));
            to[0] = force[0][k];
            to[1] = force[1][k];
            to[2] = force[2][k];
        }
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
