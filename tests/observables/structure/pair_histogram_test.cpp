#include "observables/structure/pair_histogram.hpp"

#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

/// Pairs in each bin by minimum image, bins found by comparing with their borders.
std::vector<Index> by_brute_force(const State& state, double radius, Index bins) {
    std::vector<Index> counts(static_cast<std::size_t>(bins));
    const double width = radius / static_cast<double>(bins);
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = 0; j < i; ++j) {
            const double r = state.box().minimum_image(state.positions().col(i) - state.positions().col(j)).norm();
            for (Index k = 0; k < bins; ++k) {
                if (r >= width * static_cast<double>(k) && r < width * static_cast<double>(k + 1)) {
                    ++counts[static_cast<std::size_t>(k)];
                }
            }
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("every pair within the radius is counted once, in few cells and in many") {
    // From half the shortest edge, where all cells are looked at, to an eighth; edges of 4, 5 and more cells.
    const Vec3 edges = GENERATE(Vec3(6.0, 6.0, 6.0), Vec3(5.0, 7.5, 11.0), Vec3(3.0, 3.1, 30.0));
    const double share = GENERATE(0.5, 0.41, 0.39, 0.25, 0.12);
    const Index atoms = GENERATE(1, 2, 60, 500);
    CAPTURE(edges.transpose(), share, atoms);
    State state = test::random_state(atoms, Box(edges), 17);
    const double radius = share * edges.minCoeff();
    CHECK(pair_histogram(state, radius, 7) == by_brute_force(state, radius, 7));
}

TEST_CASE("atoms that have strayed over the walls are counted where they belong") {
    State state = test::random_state(100, Box(Vec3(6.0, 7.0, 8.0)), 18);
    const std::vector<Index> inside = pair_histogram(state, 3.0, 10);
    auto r = state.write_positions();
    r.col(3) += Vec3(6.0, 0.0, 0.0);
    r.col(5) -= Vec3(0.0, 7.0, 8.0);
    CHECK(pair_histogram(state, 3.0, 10) == inside);
}

TEST_CASE("threads count the same pairs") {
    const auto counts = [](int threads) {
        const Box box(Vec3::Constant(9.0));
        return pair_histogram(test::random_state(700, box, 19, test::with_threads(threads)), 3.0, 10);
    };
    const std::vector<Index> one = counts(1);
    CHECK(counts(2) == one);
    CHECK(counts(3) == one);
}
