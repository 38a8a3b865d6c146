#include "ljmd/execution/execution.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>
#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "execution/loops.hpp"
#include "execution/test_execution.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

Index sum_to(const Execution& execution, Index count) {
    return static_cast<Index>(sum_over(execution, count, [](Index i) { return static_cast<double>(i); }));
}

}  // namespace

TEST_CASE("an execution has one thread, the default SIMD level and double precision, or what it is told") {
    {
        const test::EnvironmentGuard level("LJMD_SIMD", "portable");
        const Execution usual;
        CHECK(usual.threads() == 1);
        CHECK(usual.simd() == SimdLevel::portable);
        CHECK(usual.precision() == Precision::double_precision);
    }
    const SimdLevel level = GENERATE(from_range(usable_simd_levels()));
    const Precision precision = GENERATE(Precision::double_precision, Precision::mixed);
    const Execution told({.threads = 3, .simd = level, .precision = precision});
    CHECK(told.threads() == 3);
    CHECK(told.simd() == level);
    CHECK(told.precision() == precision);
}

TEST_CASE("the SIMD level of an execution stays when the default becomes another") {
    const Execution portable({.simd = SimdLevel::portable});
    const test::EnvironmentGuard level("LJMD_SIMD", std::string(name(usable_simd_levels().back())));
    CHECK(portable.simd() == SimdLevel::portable);
    CHECK(Execution().simd() == usable_simd_levels().back());
}

TEST_CASE("a number of threads that makes no sense is refused, with what is possible") {
    for (const int nonsense : {0, -1, max_threads + 1, std::numeric_limits<int>::max()}) {
        CAPTURE(nonsense);
        CHECK_THROWS_AS(test::with_threads(nonsense), InputError);
        CHECK_THROWS_WITH(test::with_threads(nonsense),
                          std::to_string(nonsense) + " threads: allowed are 1 to " + std::to_string(max_threads));
    }
}

TEST_CASE("a SIMD level that this processor cannot run is refused, with those that it can") {
    const std::vector<SimdLevel> usable = usable_simd_levels();
    for (const SimdLevel level : {SimdLevel::portable, SimdLevel::x86_64_v2, SimdLevel::x86_64_v3, SimdLevel::x86_64_v4,
                                  SimdLevel::x86_64_v4_256, SimdLevel::x86_64_v4_intel, SimdLevel::neon}) {
        CAPTURE(name(level));
        if (std::ranges::find(usable, level) != usable.end()) {
            CHECK(Execution({.simd = level}).simd() == level);
        } else {
            CHECK_THROWS_AS(Execution({.simd = level}), InputError);
            CHECK_THROWS_WITH(Execution({.simd = level}), Contains("cannot be used here") && Contains("portable"));
        }
    }
}

TEST_CASE("a wrong LJMD_SIMD is an error of the execution that takes the default, and of no other") {
    const test::EnvironmentGuard wrong("LJMD_SIMD", "fastest");
    CHECK_THROWS_AS(Execution(), InputError);
    CHECK_NOTHROW(Execution({.simd = SimdLevel::portable}));
}

TEST_CASE("copies share one team, which lives as long as the last of them") {
    std::optional<Execution> first(test::with_threads(2));
    const Execution copy = *first;
    CHECK(&copy.team() == &first->team());
    CHECK(&copy.team() != &test::with_threads(2).team());
    first.reset();
    CHECK(copy.threads() == 2);
    CHECK(sum_to(copy, 5000) == 5000 * 4999 / 2);
}

TEST_CASE("executions with other numbers of threads compute side by side, and one serves several threads") {
    const Execution two = test::with_threads(2);
    const Execution three = test::with_threads(3);
    const auto sums_right = [](const Execution& execution, bool& right) {
        right = true;
        for (int round = 0; round < 200; ++round) {
            right = right && sum_to(execution, 20000) == Index{20000} * 19999 / 2;
        }
    };
    std::array<bool, 3> right{};
    std::thread other([&] { sums_right(three, right[0]); });
    std::thread shared([&] { sums_right(two, right[1]); });
    sums_right(two, right[2]);
    other.join();
    shared.join();
    CHECK(right == std::array{true, true, true});
}
