#include "engine/verification/digits.hpp"

#include <string>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/execution/simd.hpp"

using namespace ljmd;

TEST_CASE("short runs have the digits that this version has on every machine, at every level that has them") {
    for (const SimdLevel level : usable_simd_levels()) {
        INFO(name(level));
        if (!has_common_digits(level)) {
            CHECK_THROWS_WITH(verify_digits({.simd = level}), Catch::Contains("digits of its own"));
            continue;
        }
        const std::vector<DigitsOfRun> runs = verify_digits({.simd = level});
        CHECK(runs.size() == 3);
        for (const DigitsOfRun& run : runs) {
            INFO(run.problem << ", " << run.rule);
            CHECK(run.found == run.wanted);
            CHECK(run.right());
        }
    }
    CHECK_FALSE(DigitsOfRun{"a run", "common-1", "0123", "4567"}.right());
}
