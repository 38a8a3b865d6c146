#include "ljmd/detail/neighbors/near_pairs.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

TEST_CASE("pairs nearer than a distance are counted once each, also across walls, and the nearest is named") {
    const State state = test::random_state(400, Box(Vec3(4.0, 5.0, 6.0)), 3);
    const double distance = GENERATE(0.01, 0.3, 1.0, 2.0);
    NearPairs expected{.count = 0, .nearest = distance};
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = i + 1; j < state.count(); ++j) {
            const double r = state.box().minimum_image(state.positions().col(i) - state.positions().col(j)).norm();
            expected.count += r < distance ? 1 : 0;
            if (r < expected.nearest) {
                expected = {expected.count, r, i, j};
            }
        }
    }
    const NearPairs found = pairs_nearer_than(state, distance);
    CHECK(found.count == expected.count);
    if (expected.count > 0) {
        CHECK(found.nearest == Approx(expected.nearest).epsilon(1e-14));
        CHECK(std::min(found.first, found.second) == expected.first);
        CHECK(std::max(found.first, found.second) == expected.second);
    } else {
        CHECK(distance == 0.01);
    }
    CHECK_THROWS_AS(pairs_nearer_than(state, 2.1), ContractViolation);
}

TEST_CASE("atoms at one place are a pair at no distance") {
    State state(3, Box(Vec3(8.0, 8.0, 8.0)));
    state.write_positions() << 1.0, 4.0, 1.0, 1.0, 4.0, 1.0, 1.0, 4.0, 1.0;
    const NearPairs found = pairs_nearer_than(state, 2.5);
    CHECK(found.count == 1);
    CHECK(found.nearest == 0.0);
    CHECK(std::min(found.first, found.second) == 0);
    CHECK(std::max(found.first, found.second) == 2);
}
