#include "neighbors/columns_around.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>
#include "catch.hpp"

#include "core/random.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

using Image = std::tuple<Index, double, double, double>;  // column and shift

}  // namespace

TEST_CASE("all atoms around a point, images included, are in columns around it, each of which is met once") {
    const Box box(GENERATE(Vec3(8.0, 8.0, 8.0), Vec3(5.1, 9.3, 17.0), Vec3(21.0, 6.0, 5.5)));
    const double density = GENERATE(0.05, 0.8442);
    const Vec3& edges = box.edges();  // rounded
    State state = test::random_state(static_cast<Index>(density * box.volume()), box, 11);
    ClusterGrid grid;
    grid.configure(box, 2.8, state.count());
    grid.sort(state);
    std::vector<std::int32_t> column_of(static_cast<std::size_t>(state.count()));
    for (std::int32_t column = 0; column < grid.column_count(); ++column) {
        const ClusterGrid::Run clusters = grid.clusters_of_column(column);
        for (Index cluster = clusters.first; cluster < clusters.last; ++cluster) {
            const AtomRange atoms = grid.atoms_of_cluster(cluster);
            std::fill(column_of.begin() + atoms.first, column_of.begin() + atoms.last, column);
        }
    }
    const auto r = state.positions();
    ColumnsAround around(grid);
    int lost = 0;
    int found = 0;
    int twice = 0;
    for (Index k = 0; k < 40; ++k) {
        // Also outside of the box, as atoms may be that moved since they were wrapped.
        const Vec3 center =
            (1.5 * Random(127, RandomStream::positions).uniform(0, k) - Vec3::Constant(0.25)).cwiseProduct(edges);
        const double radius = k % 2 == 0 ? 1.1 : 2.7;
        std::map<Image, int> met;
        const bool stopped = around.any(center, radius, [&](std::int32_t column, const Vec3& shift) {
            ++met[{column, shift[0], shift[1], shift[2]}];
            return false;
        });
        CHECK(!stopped);
        for (const auto& [image, times] : met) {
            twice += times - 1;
        }
        for (Index i = 0; i < state.count(); ++i) {
            for (int n = 0; n < 125; ++n) {
                const Eigen::Vector3i boxes(n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2);
                const Vec3 shift = boxes.cast<double>().cwiseProduct(edges);
                if ((r.col(i) + shift - center).norm() < radius) {
                    ++found;
                    lost +=
                        met.count({column_of[static_cast<std::size_t>(i)], shift[0], shift[1], shift[2]}) == 1 ? 0 : 1;
                }
            }
        }
    }
    CHECK(found > 40);
    CHECK(lost == 0);
    CHECK(twice == 0);
}

TEST_CASE("who has seen enough columns sees no more") {
    State state = test::random_state(500, Box(Vec3::Constant(9.0)), 13);
    ClusterGrid grid;
    grid.configure(state.box(), 2.8, state.count());
    grid.sort(state);
    ColumnsAround around(grid);
    int seen = 0;
    CHECK(around.any(Vec3::Constant(1.0), 2.7, [&](std::int32_t, const Vec3&) { return ++seen == 3; }));
    CHECK(seen == 3);
}
