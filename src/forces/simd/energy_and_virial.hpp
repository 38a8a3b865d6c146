#pragma once

#include <array>
#include <cstddef>

#include "forces/simd/pair_arithmetic.hpp"

/// Energy and virial of a tile, from energies of rows and forces on clusters.
/// All names have internal linkage, see cluster_forces.hpp.
namespace ljmd {

namespace {

/// Energies of a tile, in double: sums over even and over odd atoms of the rows' clusters, by slots that they meet. In
/// single precision the energies of a cluster's first two atoms are added to the last two atoms' before.
template <class V>
class EnergySum {
  public:
    using Rows = typename V::Raw[parts_per_cluster<V>][rows_per_cluster<V>];

    /// @param u  energies of the rows of a cluster, by parts that they meet and lanes; 0 for rows without an atom
    LJMD_INLINE void add_cluster(const Rows& u) {
        for (std::size_t part = 0; part < parts; ++part) {
            if constexpr (rows == 1) {
                sums_[0][part] += in_double(V(u[part][0])).raw;
            } else if constexpr (sizeof(typename V::Value) == sizeof(float)) {
                sums_[0][part] += simd::widened<V::lanes>(u[part][0]) + simd::widened<V::lanes>(u[part][1]);
            } else {
                for (std::size_t row = 0; row < rows; ++row) {
                    sums_[row % parities][part] += u[part][row];
                }
            }
        }
    }

    [[nodiscard]] double value() const {
        double even_and_odd[2][slots];
        __builtin_memcpy(even_and_odd, by_atoms().of, sizeof even_and_odd);
        double of_slot[slots];
        for (std::size_t k = 0; k < slots; ++k) {
            of_slot[k] = even_and_odd[0][k] + even_and_odd[1][k];
        }
        return (of_slot[0] + of_slot[2]) + (of_slot[1] + of_slot[3]);
    }

  private:
    static constexpr std::size_t rows = rows_per_cluster<V>;
    static constexpr std::size_t parts = parts_per_cluster<V>;
    static constexpr std::size_t others = others_per_row<V>;
    static constexpr std::size_t parities = atoms_per_row<V> == 1 ? 2 : 1;
    static constexpr int lanes = rows == 1 ? V::lanes / 2 : V::lanes;

    struct ByAtoms {
        double of[2][slots];
    };
    [[nodiscard]] ByAtoms by_atoms() const {
        ByAtoms all{};
        for (std::size_t parity = 0; parity < parities; ++parity) {
            for (std::size_t part = 0; part < parts; ++part) {
                for (std::size_t lane = 0; lane < std::size_t{lanes}; ++lane) {
                    all.of[parity + lane / others][part * others + lane % others] = sums_[parity][part][lane];
                }
            }
        }
        return all;
    }

    simd::RawVector<double, lanes> sums_[parities][parts] = {};
};

/// Virial of a tile. Each atom of its own and ghost clusters has one position in the tile, so the virial, the sum over
/// pairs of (r_i - r_j)_a f_b, equals the sum over atoms of r_a f_b.
class VirialSum {
  public:
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

    [[nodiscard]] std::array<double, 6> value() const {
        return {simd::sum_of<slots>(xx_), simd::sum_of<slots>(yy_), simd::sum_of<slots>(zz_),
                simd::sum_of<slots>(xy_), simd::sum_of<slots>(xz_), simd::sum_of<slots>(yz_)};
    }

  private:
    Four xx_{}, yy_{}, zz_{}, xy_{}, xz_{}, yz_{};
};

}  // namespace

}  // namespace ljmd
