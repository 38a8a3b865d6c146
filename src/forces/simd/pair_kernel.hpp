#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "ljmd/core/types.hpp"
#include "ljmd/execution/simd_levels.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"
#include "ljmd/neighbors/row_shape.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// The pairs of a tile: those among its atoms, and of these with its guests.
struct PairKernelTask {
    const void* positions;  ///< see TilePositions; double [sigma], for the mixed kernels std::int32_t in units of
                            ///< FixedPoint
    double unit;            ///< of the latter [sigma]
    std::int32_t own_clusters;
    std::int32_t clusters;             ///< with the guests
    const std::uint32_t* first_atoms;  ///< of each of its own clusters, and one more
    const std::int32_t* entries;       ///< see VerletList::Tile
    const std::uint32_t* starts;       ///< see VerletList::Tile
    double cutoff2;                    ///< squared cutoff [sigma^2]
    void* partial_forces;              ///< 12 zeros a cluster and atom of a row, which are zeros again in the end;
                                       ///< double, float if mixed
    double* forces;                    ///< x y z 0 of every atom: forces on the tile's own [epsilon/sigma]
    double* guest_forces;              ///< x y z of every slot of its guests, and one more number [epsilon/sigma]
};

/// Over the pairs of a task, each once.
struct PairKernelSums {
    double energy;                 ///< [epsilon]
    std::array<double, 6> virial;  ///< xx yy zz xy xz yz [epsilon]
};

/// Write what the pairs of a task do to its atoms and its guests, and what they sum up to if `sums` is wanted.
/// @param pair  a potential of the type that the kernel is compiled for
using PairKernel = void (*)(const void* pair, const PairKernelTask& task, PairKernelSums* sums);

/// Kernels for every potential, in the order of AnyPair; [0] for forces alone, [1] for energy and virial too.
using PairKernelsOfPotentials = std::array<std::array<PairKernel, 2>, std::variant_size_v<AnyPair>>;

struct PairKernels {
    RowShape row_shapes[2];  ///< by precision
    PairKernelsOfPotentials by_precision[2];
};

/// Those compiled for a level; the level must be usable here.
[[nodiscard]] inline const PairKernels& pair_kernels(SimdLevel level) {
    return *simd::compiled_for<const PairKernels*>(level);
}

}  // namespace ljmd
