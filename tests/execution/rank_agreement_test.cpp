#include "execution/rank_agreement.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>
#include "catch.hpp"

#include "execution/rank_team.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

const std::vector<SimdLevel> avx2{SimdLevel::portable, SimdLevel::x86_64_v2, SimdLevel::x86_64_v3};
const std::vector<SimdLevel> avx512{SimdLevel::portable,  SimdLevel::x86_64_v2,     SimdLevel::x86_64_v3,
                                    SimdLevel::x86_64_v4, SimdLevel::x86_64_v4_256, SimdLevel::x86_64_v4_intel};

const RankNumerics haswell{"1.0", 7, std::nullopt, SimdLevel::x86_64_v3, avx2};
const RankNumerics zen4{"1.0", 7, std::nullopt, SimdLevel::x86_64_v4_256, avx512};
const RankNumerics zen5{"1.0", 7, std::nullopt, SimdLevel::x86_64_v4, avx512};

RankNumerics asking(RankNumerics numerics, SimdLevel level) {
    numerics.asked = level;
    return numerics;
}

AgreedLevel level_of(const std::vector<RankNumerics>& ranks) {
    return agreed_level(ranks);
}

}  // namespace

TEST_CASE("ranks on equal processors take their best level, and nothing is to be told") {
    const AgreedLevel agreed = level_of({zen4, zen4, zen4});
    CHECK(agreed.level == SimdLevel::x86_64_v4_256);
    CHECK_FALSE(agreed.differs);
}

TEST_CASE("ranks on different processors take the highest level that all have, in whatever order they stand") {
    CHECK(level_of({zen5, haswell}).level == SimdLevel::x86_64_v3);
    CHECK(level_of({haswell, zen5}).level == SimdLevel::x86_64_v3);
    CHECK(level_of({haswell, zen5}).differs);
    CHECK(level_of({zen5, zen4}).level == level_of({zen4, zen5}).level);
}

TEST_CASE("a level that a rank asks for is taken by all, and refused if not all have it or another is asked for") {
    const AgreedLevel agreed = level_of({zen5, asking(zen5, SimdLevel::x86_64_v2)});
    CHECK(agreed.level == SimdLevel::x86_64_v2);
    CHECK(agreed.differs);
    CHECK_FALSE(level_of({asking(zen5, SimdLevel::x86_64_v3), asking(haswell, SimdLevel::x86_64_v3)}).differs);
    CHECK_THROWS_WITH(level_of({asking(zen5, SimdLevel::x86_64_v4), haswell}),
                      Contains("x86-64-v4 is asked for, and not all ranks have"));
    CHECK_THROWS_WITH(level_of({asking(zen5, SimdLevel::x86_64_v4), zen5, asking(zen5, SimdLevel::x86_64_v3)}),
                      Contains("x86-64-v4 is asked for at one rank, and x86-64-v3 at rank 2"));
}

TEST_CASE("ranks with other programs or other elementary functions are refused") {
    RankNumerics other = zen5;
    other.program = "1.1";
    CHECK_THROWS_WITH(level_of({zen5, other}), Contains("rank 0 is ljmd 1.0, and rank 1 is 1.1"));
    other = zen5;
    other.elementary_functions = 8;
    CHECK_THROWS_WITH(level_of({zen5, zen5, other}), Contains("exp, log") && Contains("rank 2"));
}

TEST_CASE("what ranks tell each other is what they have") {
    const SimdLevel lowest = usable_simd_levels().front();
    for (const std::optional<SimdLevel> asked : {std::optional<SimdLevel>(), std::optional(lowest)}) {
        std::vector<AgreedLevel> found(3);
        test::RankTeam team(3);
        team.run([&](std::shared_ptr<Ranks> ranks) {
            found[static_cast<std::size_t>(ranks->rank())] =
                agreed_level(*ranks, ranks->rank() == 1 ? asked : std::nullopt);
        });
        for (const AgreedLevel& one : found) {
            CHECK(one.level == asked.value_or(best_simd_level()));
            CHECK(one.differs == (one.level != best_simd_level()));
        }
    }
    CHECK(own_numerics({}).elementary_functions == own_numerics({}).elementary_functions);
}
