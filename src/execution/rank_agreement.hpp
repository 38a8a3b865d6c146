#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "execution/ranks.hpp"
#include "ljmd/detail/execution/simd.hpp"

namespace ljmd {

/// What decides the bits of a rank's part of a run, beside the deck: ranks may stand on different processors, and start
/// different programs.
struct RankNumerics {
    std::string program;                 ///< version and commit
    std::uint64_t elementary_functions;  ///< hash of values of the C library's: they differ with and without FMA
    std::optional<SimdLevel> asked;      ///< by the caller
    SimdLevel best;                      ///< taken where nobody asks
    std::vector<SimdLevel> usable;
};

/// The numerics of this process.
[[nodiscard]] RankNumerics own_numerics(std::optional<SimdLevel> asked);

/// The level with which all ranks compute.
struct AgreedLevel {
    SimdLevel level;
    bool differs;  ///< from the best one, or what was asked for, of a rank
};

/// The level asked for, if any rank asks; else the highest one that is the best of a rank and usable by all.
/// @throws InputError  ranks have other programs or other elementary functions than rank 0; they ask for different
///                     levels, or for one that not all can use
[[nodiscard]] AgreedLevel agreed_level(std::span<const RankNumerics> of_ranks);

/// The same with the numerics of all ranks. Collective: it throws at all of them or at none.
[[nodiscard]] AgreedLevel agreed_level(Ranks& ranks, std::optional<SimdLevel> asked);

}  // namespace ljmd
