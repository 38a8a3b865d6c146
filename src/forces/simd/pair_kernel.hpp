#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include "ljmd/core/simd_levels.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Consecutive atoms whose forces are wanted, and their neighbours.
struct PairKernelTask {
    const double* positions;      ///< x y z 0 of every point [sigma]; for the kernels in double
    const std::int32_t* fixed;    ///< the same in units of FixedPoint; for the mixed ones
    double unit;                  ///< of these [sigma]
    Index first;                  ///< atom
    int count;                    ///< of atoms
    const std::int32_t* entries;  ///< see VerletList::Block
    const std::uint32_t* starts;  ///< of the atoms' lists in `entries`; count + 1 numbers
    double cutoff2;               ///< squared cutoff [sigma^2]
    double* forces;               ///< x y z 0 of every atom [epsilon/sigma]
};

/// Over the atoms of a task; every pair counts whole from each of its atoms.
struct PairKernelSums {
    double energy;                 ///< [epsilon]
    std::array<double, 6> virial;  ///< xx yy zz xy xz yz [epsilon]
};

/// Write the forces on the atoms of a task, and what they sum up to if `sums` is wanted.
/// @param pair  a potential of the type that the kernel is compiled for
using PairKernel = void (*)(const void* pair, const PairKernelTask& task, PairKernelSums* sums);

/// Kernels for every potential, in the order of AnyPair; [0] for forces alone, [1] for energy and virial too.
using PairKernelsOfPotentials = std::array<std::array<PairKernel, 2>, std::variant_size_v<AnyPair>>;

struct PairKernels {
    int lanes[2];  ///< to a multiple of which lists must be filled up, by precision
    PairKernelsOfPotentials by_precision[2];
};

/// Those compiled for a level; the level must be usable here.
[[nodiscard]] inline const PairKernels& pair_kernels(SimdLevel level) {
    return *simd::compiled_for<const PairKernels*>(level);
}

}  // namespace ljmd
