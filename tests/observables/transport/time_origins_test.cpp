#include "observables/transport/time_origins.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("origins are equally spaced within the largest time, and no more than there are configurations") {
    CHECK(frames_between_origins({10, 12, 0.1}, 4) == 3);
    CHECK(frames_between_origins({10, 12, 0.1}, 5) == 3);
    CHECK(frames_between_origins({10, 12, 0.1}, 12) == 1);
    CHECK(frames_between_origins({10, 12, 0.1}, 100) == 1);
    CHECK(frames_between_origins({10, 1, 0.1}, 1) == 1);
}

TEST_CASE("origins of a checkpoint have the ages that they must have by then") {
    // An origin is what its age should be. Every third frame one begins, and is kept up to the age 5.
    const auto sound = [](const std::vector<Index>& origins, Index frames) {
        require_origins(
            origins, frames, 3, 5, [](Index origin, Index age) { return origin == age; }, "a test");
    };
    CHECK_NOTHROW(sound({}, 0));
    CHECK_NOTHROW(sound({1}, 1));
    CHECK_NOTHROW(sound({3}, 3));
    CHECK_NOTHROW(sound({4, 1}, 4));
    CHECK_NOTHROW(sound({3}, 6));  // the one before is 6 frames old
    CHECK_NOTHROW(sound({5, 2}, 8));
    CHECK_THROWS_AS(sound({1}, 0), CheckpointError);
    CHECK_THROWS_AS(sound({}, 1), CheckpointError);
    CHECK_THROWS_AS(sound({2}, 1), CheckpointError);
    CHECK_THROWS_AS(sound({1}, 4), CheckpointError);
    CHECK_THROWS_AS(sound({6, 3}, 6), CheckpointError);
    CHECK_THROWS_WITH(sound({2}, 8), "it lacks time origins of a test");
}
