#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "observables/structure/density_modes.hpp"

using namespace ljmd;

TEST_CASE("density modes are the sums over atoms that define them") {
    const Box box(Vec3(4.0, 5.5, 7.0));
    const State state = test::random_state(50, box, 3);
    const auto modes = direct_density_modes(box, {4, 5, 6});
    modes->prepare(state);
    for (const Index n_x : {-4, -1, 0, 3, 4}) {
        for (const Index n_y : {-5, -2, 0, 1, 5}) {
            std::vector<std::complex<double>> rod(7);
            modes->get(n_x, n_y, rod);
            for (Index n_z = 0; n_z < 7; ++n_z) {
                const Vec3 n(static_cast<double>(n_x), static_cast<double>(n_y), static_cast<double>(n_z));
                std::complex<double> expected = 0.0;
                for (Index i = 0; i < state.count(); ++i) {
                    const double turns = n.dot(state.positions().col(i).cwiseQuotient(box.edges()));
                    expected += std::polar(1.0, -2.0 * std::numbers::pi * turns);
                }
                CHECK(std::abs(rod[static_cast<std::size_t>(n_z)] - expected) < 1e-12);
            }
        }
    }
}
