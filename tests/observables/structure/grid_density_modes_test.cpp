#include <cmath>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/structure/density_modes.hpp"

using namespace ljmd;

namespace {

using Rod = std::vector<std::complex<double>>;

std::vector<Rod> rods(DensityModes& modes, const State& state, const DensityModes::Numbers& largest) {
    modes.prepare(state);
    std::vector<Rod> found;
    for (Index n_x = -largest[0]; n_x <= largest[0]; ++n_x) {
        for (Index n_y = -largest[1]; n_y <= largest[1]; ++n_y) {
            found.emplace_back(static_cast<std::size_t>(largest[2] + 1));
            modes.get(n_x, n_y, found.back());
        }
    }
    return found;
}

double largest_difference(const std::vector<Rod>& a, const std::vector<Rod>& b) {
    double largest = 0.0;
    REQUIRE(a.size() == b.size());
    for (std::size_t r = 0; r < a.size(); ++r) {
        for (std::size_t n = 0; n < a[r].size(); ++n) {
            largest = std::max(largest, std::abs(a[r][n] - b[r][n]));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("density modes from the grid are those from sums, all of them") {
    const auto [edges, largest] = GENERATE(table<Vec3, DensityModes::Numbers>(
        {{Vec3(4.0, 5.5, 7.0), {4, 5, 6}}, {Vec3(3.0, 3.0, 30.0), {1, 0, 40}}, {Vec3(9.0, 9.0, 9.0), {20, 21, 22}}}));
    const Index atoms = GENERATE(1, 300);
    const Box box(edges);
    State state = test::random_state(atoms, box, 5);
    auto r = state.write_positions();
    r.col(0) = Vec3(-0.1, edges[1] + 0.2, 0.0);  // atoms may stray over the walls between two rebuilds of a list
    const double difference = largest_difference(rods(*grid_density_modes(box, largest), state, largest),
                                                 rods(*direct_density_modes(box, largest), state, largest));
    CAPTURE(edges.transpose(), atoms);
    CHECK(difference < 1e-11 * static_cast<double>(atoms));
}

TEST_CASE("threads change no bit of density modes") {
    const Box box(Vec3(6.0, 7.0, 8.0));
    const DensityModes::Numbers largest{8, 9, 10};
    std::vector<std::vector<Rod>> found;
    for (const int threads : {1, 2, 3}) {
        const State state = test::random_state(500, box, 6, test::with_threads(threads));
        found.push_back(rods(*grid_density_modes(box, largest), state, largest));
    }
    CHECK(found[1] == found[0]);
    CHECK(found[2] == found[0]);
}

TEST_CASE("a grid serves one configuration after the other") {
    const Box box(Vec3::Constant(6.0));
    const DensityModes::Numbers largest{6, 6, 6};
    const State first = test::random_state(40, box, 7);
    const State second = test::random_state(60, box, 8);
    const auto modes = grid_density_modes(box, largest);
    const auto of_first = rods(*modes, first, largest);
    const auto of_second = rods(*modes, second, largest);
    CHECK(of_second == rods(*grid_density_modes(box, largest), second, largest));
    CHECK(of_first == rods(*modes, first, largest));
}
