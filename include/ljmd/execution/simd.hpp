#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

/// Instruction sets that the kernels (pair sum, list building) are compiled for. The levels of x86-64 are those of its
/// psABI: v2 has SSE4.2, v3 AVX2 and FMA, v4 AVX-512. v4_intel is AVX-512 in the order that suits processors which
/// divide slowly and add by the units that multiply, as Intel's do. `portable` is what the compiler makes of the same
/// code for the processor that the rest of the program is compiled for.
///
/// Results of two levels differ by rounding (sums are split into as many partial sums as a vector has lanes).
enum class SimdLevel { portable, x86_64_v2, x86_64_v3, x86_64_v4, x86_64_v4_intel };

/// "portable", "x86-64-v2", ...
[[nodiscard]] std::string_view name(SimdLevel level);

/// The levels that this program has code for, lowest first.
[[nodiscard]] std::vector<SimdLevel> compiled_simd_levels();

/// Those of them that this processor can run.
[[nodiscard]] std::vector<SimdLevel> usable_simd_levels();

/// The level of that name. @throws InputError for one that is unknown, or that this processor or program does not have
[[nodiscard]] SimdLevel usable_simd_level(const std::string& name);

/// What kernels use that are not told otherwise: the level set, else the one named by the environment variable
/// LJMD_SIMD, else the highest usable (v4_intel on processors of Intel alone).
/// @throws InputError as usable_simd_level
[[nodiscard]] SimdLevel default_simd_level();

/// Set it for this process. @pre level is usable here
void set_default_simd_level(SimdLevel level);

/// Numbers that the pair sum computes in. Positions, velocities, totals and integration are in double always.
enum class Precision {
    double_precision,
    /// separations from exact differences of positions in fixed point, pair terms in single, sums over atoms in double
    mixed
};

/// "double", "mixed"
[[nodiscard]] std::string_view name(Precision precision);

/// @throws InputError for another name
[[nodiscard]] Precision precision_of(const std::string& name);

}  // namespace ljmd
