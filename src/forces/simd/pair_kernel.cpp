// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "pair_kernel.hpp"

#include "ljmd/core/simd_vector.hpp"
#include "load_points.hpp"

namespace ljmd {

namespace {

/// Separations of one atom from as many neighbours as a vector has lanes.
template <class V>
struct Separation {
    V dx, dy, dz;  ///< in the arithmetic's unit
    V r2;          ///< [sigma^2]
};

/// Everything in double.
class DoubleArithmetic {
  public:
    using V = simd::Doubles;

    explicit DoubleArithmetic(const PairKernelTask& task) : positions_(task.positions) {}

    LJMD_INLINE void go_to(Index atom) {
        x_ = V(positions_[4 * atom]);
        y_ = V(positions_[4 * atom + 1]);
        z_ = V(positions_[4 * atom + 2]);
    }

    LJMD_INLINE Separation<V> separation(const std::int32_t* entries) const {
        const auto other = simd::load_points<double, V::lanes>(positions_, entries);
        const V dx = x_ - V(other.x);
        const V dy = y_ - V(other.y);
        const V dz = z_ - V(other.z);
        return {dx, dy, dz, dx * dx + dy * dy + dz * dz};
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

    explicit MixedArithmetic(const PairKernelTask& task)
        : positions_(task.fixed), unit_(task.unit), unit2_(task.unit * task.unit) {}

    LJMD_INLINE void go_to(Index atom) {
        x_ = positions_[4 * atom] - Raw{};
        y_ = positions_[4 * atom + 1] - Raw{};
        z_ = positions_[4 * atom + 2] - Raw{};
    }

    LJMD_INLINE Separation<V> separation(const std::int32_t* entries) const {
        const auto other = simd::load_points<std::int32_t, V::lanes>(positions_, entries);
        const V dx(__builtin_convertvector(x_ - other.x, V::Raw));
        const V dy(__builtin_convertvector(y_ - other.y, V::Raw));
        const V dz(__builtin_convertvector(z_ - other.z, V::Raw));
        return {dx, dy, dz, fma(dz, dz, fma(dy, dy, dx * dx)) * unit2_};
    }

    [[nodiscard]] double unit() const { return unit_; }

  private:
    using Raw = simd::RawVector<std::int32_t, V::lanes>;

    const std::int32_t* positions_;
    double unit_;
    V unit2_;
    Raw x_, y_, z_;
};

/// Sums over the neighbours of one atom, by lanes.
template <class V, bool with_energy>
struct Sums {
    V fx{0}, fy{0}, fz{0};
    V u{0}, xx{0}, yy{0}, zz{0}, xy{0}, xz{0}, yz{0};

    template <class Pair>
    LJMD_INLINE void add(const Pair& pair, V cutoff2, const Separation<V>& d) {
        const auto term = pair(d.r2);
        const V w = where_less(d.r2, cutoff2, term.w);
        fx = fma(w, d.dx, fx);
        fy = fma(w, d.dy, fy);
        fz = fma(w, d.dz, fz);
        if constexpr (with_energy) {
            u += where_less(d.r2, cutoff2, term.u);
            const V wx = w * d.dx;
            const V wy = w * d.dy;
            xx = fma(wx, d.dx, xx);
            yy = fma(wy, d.dy, yy);
            zz = fma(w * d.dz, d.dz, zz);
            xy = fma(wx, d.dy, xy);
            xz = fma(wx, d.dz, xz);
            yz = fma(wy, d.dz, yz);
        }
    }
};

/// The neighbours of an atom come in groups of as many as a vector has lanes. While one group is summed up, the next is
/// on its way from memory, across the end of an atom's list too: else the processor waits for it.
template <class Arithmetic, bool with_energy, class Pair>
[[gnu::flatten]] void sum_block(const void* potential, const PairKernelTask& task, PairKernelSums* sums) {
    using V = typename Arithmetic::V;
    const Pair pair = *static_cast<const Pair*>(potential);
    const V cutoff2(task.cutoff2);
    Arithmetic arithmetic(task);
    PairKernelSums total{};
    arithmetic.go_to(task.first);
    Separation<V> current = arithmetic.separation(task.entries + task.starts[0]);
    for (int k = 0; k < task.count; ++k) {
        Sums<V, with_energy> sum_of_atom;
        const std::uint32_t last = task.starts[k + 1];
        for (std::uint32_t e = task.starts[k] + V::lanes; e < last; e += V::lanes) {
            const Separation<V> before = current;
            current = arithmetic.separation(task.entries + e);
            sum_of_atom.add(pair, cutoff2, before);
        }
        const int following = k + 1 < task.count ? k + 1 : k;
        arithmetic.go_to(task.first + following);
        const Separation<V> before = current;
        current = arithmetic.separation(task.entries + task.starts[following]);
        sum_of_atom.add(pair, cutoff2, before);

        double* force = task.forces + 4 * (task.first + k);
        force[0] = sum(sum_of_atom.fx) * arithmetic.unit();
        force[1] = sum(sum_of_atom.fy) * arithmetic.unit();
        force[2] = sum(sum_of_atom.fz) * arithmetic.unit();
        if constexpr (with_energy) {
            total.energy += sum(sum_of_atom.u);
            total.virial[0] += sum(sum_of_atom.xx);
            total.virial[1] += sum(sum_of_atom.yy);
            total.virial[2] += sum(sum_of_atom.zz);
            total.virial[3] += sum(sum_of_atom.xy);
            total.virial[4] += sum(sum_of_atom.xz);
            total.virial[5] += sum(sum_of_atom.yz);
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
    return {{{{&sum_block<Arithmetic, false, Pairs>, &sum_block<Arithmetic, true, Pairs>}}...}};
}

constexpr PairKernels kernels{{DoubleArithmetic::V::lanes, MixedArithmetic::V::lanes},
                              {kernels_for<DoubleArithmetic>(static_cast<const AnyPair*>(nullptr)),
                               kernels_for<MixedArithmetic>(static_cast<const AnyPair*>(nullptr))}};

}  // namespace

template <>
const PairKernels* simd::compiled_here<const PairKernels*, simd::Here>() {
    return &kernels;
}

}  // namespace ljmd
