#include "ljmd/detail/execution/simd.hpp"

#include <algorithm>
#include <string>
#include <vector>
#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("the usable SIMD levels are among those compiled in, lowest first, portable always") {
    const auto compiled = compiled_simd_levels();
    const auto usable = usable_simd_levels();
    REQUIRE(!usable.empty());
    CHECK(usable.front() == SimdLevel::portable);
    CHECK(std::is_sorted(usable.begin(), usable.end()));
    CHECK(std::includes(compiled.begin(), compiled.end(), usable.begin(), usable.end()));
    for (const SimdLevel level : usable) {
        CHECK(usable_simd_level(std::string(name(level))) == level);
    }
}

TEST_CASE("a SIMD level that is unknown, or that this processor lacks, is refused with those there are") {
    CHECK_THROWS_WITH(usable_simd_level("avx3"), Catch::StartsWith("unknown SIMD level 'avx3', usable here: portable"));
    const auto usable = usable_simd_levels();
    for (const char* level : {"x86-64-v2", "x86-64-v3", "x86-64-v4", "x86-64-v4-256", "x86-64-v4-intel"}) {
        if (std::none_of(usable.begin(), usable.end(), [&](SimdLevel here) { return name(here) == level; })) {
            CHECK_THROWS_WITH(usable_simd_level(level), Catch::Contains("cannot be used here"));
        }
    }
}

TEST_CASE("the default SIMD level is the highest usable one made for this processor, or what LJMD_SIMD says") {
    {
        const test::EnvironmentGuard nothing("LJMD_SIMD", "");
        const SimdLevel best = default_simd_level();
        const SimdLevel highest = usable_simd_levels().back();
        if (highest < SimdLevel::x86_64_v4 || highest == SimdLevel::neon) {
            CHECK(best == highest);
        } else {
#if defined(__x86_64__)
            CHECK(has_common_digits(best));
            CHECK((best == SimdLevel::x86_64_v4_256) == (__builtin_cpu_is("amdfam19h") != 0));
#endif
        }
    }
    {
        const test::EnvironmentGuard portable("LJMD_SIMD", "portable");
        CHECK(default_simd_level() == SimdLevel::portable);
    }
    const test::EnvironmentGuard wrong("LJMD_SIMD", "fastest");
    CHECK_THROWS_AS(default_simd_level(), InputError);
}

TEST_CASE("a run is continued at its level, or at the highest with the same digits") {
    using enum SimdLevel;
    const std::vector<SimdLevel> old_processor{portable, x86_64_v2, x86_64_v3};
    const std::vector<SimdLevel> arm{portable, neon};
    CHECK(level_with_digits_of("x86-64-v4", Precision::double_precision, arm) == neon);
    CHECK(level_with_digits_of("x86-64-v3", Precision::mixed, arm) == neon);
    CHECK(level_with_digits_of("x86-64-v2", Precision::mixed, arm) == portable);
    CHECK(level_with_digits_of("neon", Precision::mixed, old_processor) == x86_64_v3);
    constexpr Precision full = Precision::double_precision;
    CHECK(level_with_digits_of("x86-64-v2", full, old_processor) == x86_64_v2);
    CHECK(level_with_digits_of("x86-64-v4", full, old_processor) == x86_64_v3);
    CHECK(level_with_digits_of("x86-64-v4", Precision::mixed, old_processor) == x86_64_v3);
    CHECK(level_with_digits_of("x86-64-v4-256", full, {portable, x86_64_v2}) == x86_64_v2);
    CHECK(digits_rule(x86_64_v4, Precision::mixed) != digits_rule(x86_64_v2, Precision::mixed));
    CHECK(digits_rule(x86_64_v4, full) != digits_rule(x86_64_v4_intel, full));
    const auto usable = usable_simd_levels();
    if (std::ranges::find(usable, x86_64_v4) == usable.end()) {
        CHECK_THROWS_WITH(level_with_digits_of("x86-64-v4-intel", full), Catch::Contains("cannot be used here"));
    }
    CHECK_THROWS_WITH(level_with_digits_of("avx3", full), Catch::Contains("unknown SIMD level"));
}

TEST_CASE("precisions have names") {
    CHECK(name(Precision::double_precision) == "double");
    CHECK(name(Precision::mixed) == "mixed");
}
