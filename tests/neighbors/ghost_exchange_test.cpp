#include "neighbors/ghost_exchange.hpp"

#include <random>
#include <vector>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

/// Every ghost is its atom plus whole edges, to the last bit, in the order of the runs.
bool ghosts_follow(const State& state, const std::vector<GhostExchange::Run>& runs) {
    const auto all = state.positions_and_ghosts();
    Index ghost = state.count();
    for (const auto& run : runs) {
        for (Index i = run.first; i < run.first + run.count; ++i, ++ghost) {
            if (ghost >= all.cols() || all.col(ghost) != all.col(i) + run.shift ||
                all.col(ghost) - run.shift != all.col(i)) {
                return false;
            }
        }
    }
    return ghost == all.cols();
}

}  // namespace

TEST_CASE("ghosts are the atoms of the runs, whole edges away, and follow them to the last bit") {
    const int threads = GENERATE(1, 3);
    const Box box(Vec3(4.3, 5.1, 6.7));
    State state = test::random_state(60, box, 3, test::with_threads(threads));
    std::vector<GhostExchange::Run> runs;
    for (Index k = 0; k < 50; ++k) {  // more than one thread takes at a time
        const Vec3 edges(static_cast<double>(k % 3 - 1), static_cast<double>(k % 5 - 2), 1.0);
        runs.push_back({k, k % 10, edges.cwiseProduct(box.edges())});
    }
    GhostExchange ghosts;
    ghosts.create(state, runs);
    CHECK(ghosts.count() == 225);
    CHECK(state.ghost_count() == 225);
    CHECK(ghosts_follow(state, runs));

    std::mt19937_64 generator(11);
    for (int step = 0; step < 20; ++step) {
        test::displace(state, 0.05, generator);  // atoms leave the box
        CHECK_FALSE(ghosts_follow(state, runs));
        ghosts.update(state);
        CHECK(ghosts_follow(state, runs));
    }
}

TEST_CASE("ghosts leave atoms and the forces' being current, and are replaced by the next ones") {
    const Box box(Vec3::Constant(5.0));
    const State before = test::random_state(40, box, 5);
    State state = before;
    GhostExchange ghosts;
    state.mark_forces_current();
    ghosts.create(state, {{0, 40, Vec3(5.0, 0.0, 0.0)}, {0, 40, Vec3(-5.0, 0.0, 0.0)}});
    CHECK(state.ghost_count() == 80);
    const std::vector<GhostExchange::Run> fewer{{7, 3, Vec3(0.0, -5.0, 0.0)}};
    ghosts.create(state, fewer);
    CHECK(ghosts.count() == 3);
    CHECK(ghosts_follow(state, fewer));
    CHECK(state.forces_are_current());
    CHECK(state.positions() == before.positions());
    CHECK(state.ids() == before.ids());
}

TEST_CASE("without runs there are no ghosts") {
    State state(0, Box(Vec3::Constant(5.0)));
    GhostExchange ghosts;
    ghosts.create(state, {});
    CHECK(ghosts.count() == 0);
    CHECK(state.ghost_count() == 0);
}
