#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

/// Instruction sets that the kernels (pair sum, list building) are compiled for. The levels of x86-64 are defined by
/// its psABI: v2 has SSE4.2, v3 AVX2 and FMA, v4 AVX-512. v4_256 is AVX-512 with vectors of 256 bits, for processors
/// whose units have half the width of its registers, as AMD's Zen 4. v4_intel is AVX-512 arranged for processors whose
/// divisions are slow and whose multipliers also add, as Intel's do. `neon` is the level of ARM64. `portable` is the
/// same code compiled for the processor that the rest of the program is compiled for.
///
/// In double precision all but v4_intel have the same digits: they add in one order, and fuse no product with a sum.
/// See digits_rule() and docs/digits.md.
enum class SimdLevel { portable, x86_64_v2, x86_64_v3, x86_64_v4, x86_64_v4_256, x86_64_v4_intel, neon };

/// "portable", "x86-64-v2", ...
[[nodiscard]] std::string_view name(SimdLevel level);

/// All levels that this program has code for, lowest first.
[[nodiscard]] std::vector<SimdLevel> compiled_simd_levels();

/// The compiled levels that this processor can run.
[[nodiscard]] std::vector<SimdLevel> usable_simd_levels();

/// The level with this name. @throws InputError if it is unknown, or not available in this processor or program
[[nodiscard]] SimdLevel usable_simd_level(const std::string& name);

/// The highest usable level that is made for this processor, of those with the common digits: with AVX-512 v4_256 on
/// Zen 4, v4 on others.
[[nodiscard]] SimdLevel best_simd_level();

/// The level named here, else by the environment variable LJMD_SIMD; none: the best one is to be taken.
/// @throws InputError as usable_simd_level
[[nodiscard]] std::optional<SimdLevel> asked_simd_level(const std::string& named = {});

/// Level of an Execution that is not given one: the one asked for, else the best.
/// @throws InputError as usable_simd_level
[[nodiscard]] SimdLevel default_simd_level(const std::string& named = {});

/// Precision of the pair sum. Positions, velocities, totals and integration are always in double.
enum class Precision {
    double_precision,
    /// separations from exact differences of fixed-point positions, pair terms in single, sums over atoms in double
    mixed
};

/// "double", "mixed"
[[nodiscard]] std::string_view name(Precision precision);

/// @throws InputError for another name
[[nodiscard]] Precision precision_of(const std::string& name);

/// Whether the level adds in the order of all others but v4_intel.
[[nodiscard]] bool has_common_digits(SimdLevel level);

/// Whether products in single precision are fused with sums: v2 and `portable` are without the instruction.
[[nodiscard]] bool fuses_single_precision(SimdLevel level);

/// By which rule the digits of a trajectory are made: "common-1", for example. Runs of one version by the same rule
/// have the same bits on every machine.
[[nodiscard]] std::string digits_rule(SimdLevel level, Precision precision);

/// The level with this name if it is usable, else the highest usable level with the same digits.
/// @throws InputError if there is none
[[nodiscard]] SimdLevel level_with_digits_of(const std::string& name, Precision precision,
                                             const std::vector<SimdLevel>& usable = usable_simd_levels());

}  // namespace ljmd
