#include "neighbors/all_pairs.hpp"

#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

/// Ordered pairs with r < cutoff over all images of the neighbouring boxes: the oracle's oracle.
std::vector<test::OrderedPair> pairs_over_images(const State& state, double cutoff) {
    std::vector<test::OrderedPair> pairs;
    const auto r = state.positions();
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = 0; j < state.count(); ++j) {
            for (int image = 0; image < 27 && i != j; ++image) {
                const Vec3 n(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
                const Vec3 d = r.col(i) - (r.col(j) + n.cwiseProduct(state.box().edges()));
                if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < cutoff * cutoff) {
                    pairs.emplace_back(i, j);
                }
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace

TEST_CASE("all pairs finds the pairs of a sum over images") {
    const Vec3 edges = GENERATE(Vec3(5.0, 5.0, 5.0), Vec3(5.0, 6.3, 9.1));
    State state = test::random_state(150, Box(edges), GENERATE(1u, 2u, 3u));
    AllPairs search;
    search.prepare(state, 2.5);
    const auto expected = pairs_over_images(state, 2.5);
    CHECK(expected.size() > 1000);
    CHECK(test::pairs_within(search, state, 2.5) == expected);
}

TEST_CASE("all pairs meets everybody else once, from both sides with opposite separations") {
    State state = test::random_state(30, Box(Vec3(5.0, 6.0, 7.0)), 4);
    AllPairs search;
    search.prepare(state, 2.5);
    std::vector<Vec3> separation(30 * 30, Vec3::Zero());
    Index met = 0;
    REQUIRE(search.part_count(state) == 1);
    search.for_each_candidate(state, 0, [&](const PairVisit& pair) {
        CHECK(pair.i != pair.j);
        CHECK_FALSE(pair.once);
        separation[static_cast<std::size_t>(30 * pair.i + pair.j)] = Vec3(pair.dx, pair.dy, pair.dz);
        ++met;
    });
    CHECK(met == 30 * 29);
    bool opposite = true;
    for (std::size_t i = 0; i < 30; ++i) {
        for (std::size_t j = 0; j < 30; ++j) {
            opposite = opposite && separation[30 * i + j] == -separation[30 * j + i];
        }
    }
    CHECK(opposite);
}

TEST_CASE("all pairs wraps atoms, keeps their order and counts its preparations") {
    const Box box(Vec3::Constant(5.0));
    State state = test::state_of({{-0.5, 1.0, 1.0}, {5.25, 1.0, 1.0}}, box);
    AllPairs search;
    search.prepare(state, 2.5);
    search.prepare(state, 2.5);
    CHECK(state.positions().col(0) == Vec3(4.5, 1.0, 1.0));
    CHECK(state.image(1) == Eigen::Vector3i(1, 0, 0));
    CHECK(state.order_version() == 0);
    CHECK(state.ghost_count() == 0);
    CHECK(search.statistics().preparations == 2);
    std::vector<Vec3> seen(2);
    search.for_each_candidate(state, 0, [&](const PairVisit& pair) {
        CHECK(pair.j == 1 - pair.i);
        seen[static_cast<std::size_t>(pair.i)] = Vec3(pair.dx, pair.dy, pair.dz);
    });
    CHECK(seen[0] == Vec3(-0.75, 0.0, 0.0));
    CHECK(seen[1] == Vec3(0.75, 0.0, 0.0));
}

TEST_CASE("all pairs reports a position that is not finite") {
    State state = test::random_state(3, Box(Vec3::Constant(5.0)), 1);
    state.write_positions()(1, 2) = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(AllPairs().prepare(state, 2.5), PhysicsError);
}
