#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "execution/simd_levels.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "neighbors/cluster_grid.hpp"
#include "neighbors/row_shape.hpp"

namespace ljmd {

/// The pairs of a tile: its own atoms with each other, and its own atoms with its ghost clusters.
struct PairKernelTask {
    const void* positions;  ///< see TilePositions: double [sigma], or std::int32_t in units of FixedPoint (mixed)
    double unit;            ///< unit of FixedPoint [sigma]
    std::int32_t own_clusters;
    std::int32_t clusters;             ///< ghosts included
    const std::uint32_t* first_atoms;  ///< first atom of each own cluster, followed by the end of the last
    const std::int32_t* entries;       ///< see VerletList::Tile
    const std::uint32_t* starts;       ///< see VerletList::Tile
    double cutoff2;                    ///< squared cutoff [sigma^2]
    void* partial_forces;              ///< numbers_per_cluster of PairKernels, zero before and after the call; double,
                                       ///< float if mixed
    double* forces;                    ///< x y z 0 of every atom; written for the tile's own [epsilon/sigma]
    double* ghost_forces;              ///< x y z of every slot of its ghosts, and one more number [epsilon/sigma]
};

/// Sums over the pairs of a task, each counted once.
struct PairKernelSums {
    double energy;                 ///< [epsilon]
    std::array<double, 6> virial;  ///< xx yy zz xy xz yz [epsilon]
};

/// Compute the forces of a task's pairs on its own atoms and on its ghosts, and the sums if `sums` is not null.
/// @param pair  a potential of the type that the kernel is compiled for
using PairKernel = void (*)(const void* pair, const PairKernelTask& task, PairKernelSums* sums);

/// Kernels for every potential, in the order of AnyPair; [0] for forces alone, [1] for energy and virial too.
using PairKernelsOfPotentials = std::array<std::array<PairKernel, 2>, std::variant_size_v<AnyPair>>;

struct PairKernels {
    RowShape row_shapes[2];              ///< by precision
    std::size_t numbers_per_cluster[2];  ///< of PairKernelTask::partial_forces, by precision
    PairKernelsOfPotentials by_precision[2];
};

/// The kernels compiled for a level. @pre the level is usable here
[[nodiscard]] inline const PairKernels& pair_kernels(SimdLevel level) {
    return *simd::compiled_for<const PairKernels*>(level);
}

}  // namespace ljmd
