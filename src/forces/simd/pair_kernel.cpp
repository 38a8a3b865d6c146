// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "pair_kernel.hpp"

#include "ljmd/core/simd_vector.hpp"

namespace ljmd {

namespace {

constexpr int slots = ClusterGrid::slots;

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
    V u{0}, xx{0}, yy{0}, zz{0}, xy{0}, xz{0}, yz{0};

    /// The pairs' part in the sums, their other side left out.
    template <class Pair>
    LJMD_INLINE void add(const Pair& pair, V cutoff2, const Separation<V>& d) {
        add_sides<1>(pair, cutoff2, d);
    }

    /// Both sides. @param others  x, y and z of minus the forces on the cluster that is met, which grow, too
    template <class Pair>
    LJMD_INLINE void add_both(const Pair& pair, V cutoff2, const Separation<V>& d, typename V::Value* others) {
        const V w = add_sides<2>(pair, cutoff2, d);
        constexpr std::size_t axis = V::lanes * pieces<V>;
        multiply_add(w, d.dx, V::load(others)).store(others);
        multiply_add(w, d.dy, V::load(others + axis)).store(others + axis);
        multiply_add(w, d.dz, V::load(others + 2 * axis)).store(others + 2 * axis);
    }

  private:
    template <int sides, class Pair>
    LJMD_INLINE V add_sides(const Pair& pair, V cutoff2, const Separation<V>& d) {
        const auto term = pair(d.r2);
        const V w = where_less(d.r2, cutoff2, term.w);
        fx = multiply_add(w, d.dx, fx);
        fy = multiply_add(w, d.dy, fy);
        fz = multiply_add(w, d.dz, fz);
        if constexpr (with_energy) {
            u = multiply_add(V(sides), where_less(d.r2, cutoff2, term.u), u);
            const V wx = V(sides) * w * d.dx;
            const V wy = V(sides) * w * d.dy;
            xx = multiply_add(wx, d.dx, xx);
            yy = multiply_add(wy, d.dy, yy);
            zz = multiply_add(V(sides) * w * d.dz, d.dz, zz);
            xy = multiply_add(wx, d.dy, xy);
            xz = multiply_add(wx, d.dz, xz);
            yz = multiply_add(wy, d.dz, yz);
        }
        return w;
    }
};

/// What to add to the squared distances of each row of a cluster from the cluster itself, so that no atom meets itself.
template <class V>
struct Aside {
    static constexpr std::size_t rows = slots / atoms_per_row<V>;
    static constexpr std::size_t numbers = V::lanes * pieces<V>;
    typename V::Value of_row[rows][numbers] = {};
    constexpr Aside() {
        for (std::size_t atom = 0; atom < slots; ++atom) {
            const std::size_t in_row = atom % (slots / rows);
            of_row[atom / (slots / rows)][in_row * slots + atom] = typename V::Value(1e15);
        }
    }
};

/// Over the lanes of a row's atom.
template <int n, class V>
LJMD_INLINE double sum_of_atom(V v) {
    if constexpr (V::lanes <= slots) {
        return sum(v);
    } else {
        return simd::sum_of_four<n>(v);
    }
}

/// Write the forces of a row's atoms. @param others  minus what they got from atoms before
template <class Arithmetic, int n, class Sums>
LJMD_INLINE void write_forces(const Arithmetic& arithmetic, const Sums& sums,
                              const typename Arithmetic::V::Value* others, int atoms, double* forces) {
    using V = typename Arithmetic::V;
    if constexpr (n < atoms_per_row<V>) {
        if (n < atoms) {
            constexpr int axis = V::lanes * static_cast<int>(pieces<V>);
            double before[3] = {};
            for (int a = 0; a < 3; ++a) {
                for (int m = 0; m < atoms_per_row<V>; ++m) {
                    before[a] += static_cast<double>(others[a * axis + m * slots + n]);
                }
            }
            double* force = forces + std::ptrdiff_t{4} * n;
            force[0] = (sum_of_atom<n>(sums.fx) - before[0]) * arithmetic.unit();
            force[1] = (sum_of_atom<n>(sums.fy) - before[1]) * arithmetic.unit();
            force[2] = (sum_of_atom<n>(sums.fz) - before[2]) * arithmetic.unit();
            write_forces<Arithmetic, n + 1>(arithmetic, sums, others, atoms, forces);
        }
    }
}

/// Row by row: its own cluster, then the clusters with which the pairs stand on the list once, then the others. When a
/// row's turn comes, all atoms that have pairs with it on their lists have had theirs.
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
    PairKernelSums total{};
    const auto first = static_cast<std::size_t>(task.clusters.first);
    const auto last = static_cast<std::size_t>(task.clusters.last);
    auto* partial = static_cast<Real*>(task.partial_forces);
    for (std::size_t k = 0; k < (last - first) * 3 * pieces<V>; ++k) {
        V(0).store(partial + k * V::lanes);
    }
    // Minus the forces on the atoms of a cluster of the tile, of each row's atom in lanes of its own.
    const auto others = [&](std::size_t entry) { return partial + (entry - first * stride) * width; };
    const std::int32_t* entries = task.entries;
    const std::uint32_t* row = task.starts;
    for (std::size_t cluster = first; cluster < last; ++cluster) {
        const std::size_t own = cluster * stride;
        const std::uint32_t first_atom = task.first_atoms[cluster];
        const int atoms = static_cast<int>(task.first_atoms[cluster + 1] - first_atom);
        for (int k = 0; k < atoms; k += width, row += 2) {
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
            for (std::size_t p = 0; p < pieces<V>; ++p) {
                Separation<V> d = arithmetic.separation(own + p * V::lanes);
                d.r2 += V::load_unaligned(aside.of_row[k / width] + p * V::lanes);
                sum_of_row.add(pair, cutoff2, d);
            }
            const std::uint32_t once_end = row[1];
            const std::uint32_t end = row[2];
            std::uint32_t e = row[0];
            for (; e < once_end; ++e) {
                const std::size_t entry = static_cast<std::uint32_t>(entries[e]);
                for (std::size_t p = 0; p < pieces<V>; ++p) {
                    sum_of_row.add_both(pair, cutoff2, arithmetic.separation(entry + p * V::lanes),
                                        others(entry) + p * V::lanes);
                }
            }
            for (; e < end; ++e) {
                const std::size_t entry = static_cast<std::uint32_t>(entries[e]);
                for (std::size_t p = 0; p < pieces<V>; ++p) {
                    sum_of_row.add(pair, cutoff2, arithmetic.separation(entry + p * V::lanes));
                }
            }
            write_forces<Arithmetic, 0>(arithmetic, sum_of_row, others(own) + k, atoms - k,
                                        task.forces + 4 * (first_atom + static_cast<std::size_t>(k)));
            if constexpr (with_energy) {
                total.energy += sum(sum_of_row.u);
                total.virial[0] += sum(sum_of_row.xx);
                total.virial[1] += sum(sum_of_row.yy);
                total.virial[2] += sum(sum_of_row.zz);
                total.virial[3] += sum(sum_of_row.xy);
                total.virial[4] += sum(sum_of_row.xz);
                total.virial[5] += sum(sum_of_row.yz);
            }
        }
    }
    if constexpr (with_energy) {
        sums->energy = total.energy;
        for (std::size_t a = 0; a < 6; ++a) {
            sums->virial[a] = total.virial[a] * arithmetic.unit() * arithmetic.unit();
        }
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
