#include "core/schedule.hpp"

#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("a schedule is due at 0, n, 2 n and at no other step") {
    for (const Index n : {1, 2, 3, 7, 100}) {
        const Every every(n);
        CHECK(every.steps() == n);
        Index next = 0;
        bool right = true;
        for (Index step = 0; step <= 350; ++step) {
            right = right && every.due(step) == (step == next);
            next += step == next ? n : 0;
        }
        CHECK(right);
    }
}

TEST_CASE("a schedule counts beyond 32 bits") {
    const Index far = Index{1} << 40;
    CHECK(Every(far).due(0));
    CHECK(Every(far).due(3 * far));
    CHECK_FALSE(Every(far).due(3 * far + 1));
    CHECK_FALSE(Every(std::numeric_limits<Index>::max()).due(1));
}

TEST_CASE("a schedule without a positive period cannot be made") {
    for (const Index n : {Index{0}, Index{-1}, std::numeric_limits<Index>::min()}) {
        CHECK_THROWS_AS(Every(n), InputError);
    }
}
