#include "execution/rank_agreement.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Hash of values of the functions that runs call. Variants of a function differ in the last place for one argument in
/// thousands, so there are many. The arguments are exact, and the same for all compilers.
std::uint64_t hash_of_elementary_functions() {
    constexpr int arguments = 8192;
    std::vector<double> values;
    values.reserve(std::size_t{8} * arguments);
    for (int k = 1; k <= arguments; ++k) {
        const double x = k / 1024.0 + k * 0x1p-40;
        values.insert(values.end(), {std::exp(-x), std::expm1(-x), std::log(x), std::log1p(x), std::pow(x, 1.0 / 7.0),
                                     std::cbrt(x), std::sin(3.0 * x), std::cos(3.0 * x)});
    }
    return XXH3_64bits(values.data(), values.size() * sizeof(double));
}

bool contains(const std::vector<SimdLevel>& levels, SimdLevel level) {
    return std::find(levels.begin(), levels.end(), level) != levels.end();
}

[[noreturn]] void refuse(const std::string& why) {
    throw InputError(why + ": the results would be those of no single process");
}

Ranks::Bytes message_of(const RankNumerics& numerics) {
    std::uint64_t usable = 0;
    for (const SimdLevel level : numerics.usable) {
        usable |= std::uint64_t{1} << static_cast<unsigned>(level);
    }
    const std::uint64_t numbers[] = {numerics.elementary_functions,
                                     numerics.asked ? static_cast<std::uint64_t>(*numerics.asked) + 1 : 0,
                                     static_cast<std::uint64_t>(numerics.best), usable};
    Ranks::Bytes bytes(sizeof numbers + numerics.program.size());
    std::memcpy(bytes.data(), numbers, sizeof numbers);
    std::memcpy(bytes.data() + sizeof numbers, numerics.program.data(), numerics.program.size());
    return bytes;
}

RankNumerics numerics_of(const Ranks::Bytes& bytes) {
    std::uint64_t numbers[4];
    std::memcpy(numbers, bytes.data(), sizeof numbers);
    RankNumerics numerics{
        .program =
            std::string(reinterpret_cast<const char*>(bytes.data()) + sizeof numbers, bytes.size() - sizeof numbers),
        .elementary_functions = numbers[0],
        .asked = numbers[1] > 0 ? std::optional(static_cast<SimdLevel>(numbers[1] - 1)) : std::nullopt,
        .best = static_cast<SimdLevel>(numbers[2]),
        .usable = {}};
    for (unsigned level = 0; level < 64; ++level) {
        if ((numbers[3] >> level & 1U) != 0) {
            numerics.usable.push_back(static_cast<SimdLevel>(level));
        }
    }
    return numerics;
}

}  // namespace

RankNumerics own_numerics(std::optional<SimdLevel> asked) {
    return {.program = fmt::format("{}, commit {}", build_info().version, build_info().commit),
            .elementary_functions = hash_of_elementary_functions(),
            .asked = asked,
            .best = best_simd_level(),
            .usable = usable_simd_levels()};
}

AgreedLevel agreed_level(std::span<const RankNumerics> of_ranks) {
    const RankNumerics& first = of_ranks.front();
    std::optional<SimdLevel> asked;
    for (std::size_t rank = 0; rank < of_ranks.size(); ++rank) {
        const RankNumerics& one = of_ranks[rank];
        if (one.program != first.program) {
            refuse(fmt::format("rank 0 is ljmd {}, and rank {} is {}", first.program, rank, one.program));
        }
        if (one.elementary_functions != first.elementary_functions) {
            refuse(fmt::format("the C library's exp, log and others have other last digits at rank {} than at rank 0",
                               rank));
        }
        if (asked && one.asked && *one.asked != *asked) {
            refuse(fmt::format("SIMD level {} is asked for at one rank, and {} at rank {}", name(*asked),
                               name(*one.asked), rank));
        }
        if (one.asked) {
            asked = one.asked;
        }
    }
    const auto usable_by_all = [&](SimdLevel level) {
        return std::all_of(of_ranks.begin(), of_ranks.end(),
                           [&](const RankNumerics& one) { return contains(one.usable, level); });
    };
    if (asked && !usable_by_all(*asked)) {
        throw InputError(
            fmt::format("SIMD level {} is asked for, and not all ranks have a processor with it", name(*asked)));
    }
    std::optional<SimdLevel> level = asked;
    if (!level) {
        for (const RankNumerics& one : of_ranks) {
            if (usable_by_all(one.best)) {
                level = std::max(level.value_or(one.best), one.best);
            }
        }
    }
    const AgreedLevel agreed{.level = level.value_or(SimdLevel::portable), .differs = false};
    return {agreed.level, std::any_of(of_ranks.begin(), of_ranks.end(), [&](const RankNumerics& one) {
                return one.asked.value_or(one.best) != agreed.level;
            })};
}

AgreedLevel agreed_level(Ranks& ranks, std::optional<SimdLevel> asked) {
    std::vector<RankNumerics> of_ranks;
    for (const Ranks::Bytes& bytes : ranks.exchange(
             std::vector<Ranks::Bytes>(static_cast<std::size_t>(ranks.size()), message_of(own_numerics(asked))))) {
        of_ranks.push_back(numerics_of(bytes));
    }
    return agreed_level(of_ranks);
}

}  // namespace ljmd
