#include "ljmd/neighbors/cluster_grid.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

ClusterGrid sorted(State& state, double range) {
    ClusterGrid grid;
    grid.configure(state.box(), range, state.count());
    grid.sort(state);
    return grid;
}

/// Numbers of clusters that a cluster may meet, once and from both sides.
std::array<std::vector<Index>, 2> met_by(const ClusterGrid& grid, std::int32_t column, Index cluster) {
    std::array<std::vector<Index>, 2> met;
    std::vector<ClusterGrid::Near> near;
    grid.find_near(column, near);
    for (const ClusterGrid::Near& other : near) {
        if (grid.may_reach(other, grid.extent(cluster))) {
            const ClusterGrid::Run window = grid.window(other, grid.extent(cluster));
            for (Index n = window.first; n < window.last; ++n) {
                met[other.once ? 0 : 1].push_back(n + other.column.offset);
            }
        }
    }
    return met;
}

}  // namespace

TEST_CASE("clusters are the atoms in their order, four and four, and tiles are clusters in theirs") {
    const Index atoms = GENERATE(0, 1, 5, 300, 9000);
    const double density = GENERATE(0.01, 0.8442);
    const Box box(std::cbrt(static_cast<double>(std::max<Index>(atoms, 50)) / density / 3.0) * Vec3(1.0, 1.5, 2.0));
    State state = test::random_state(atoms, box, 3);
    const ClusterGrid grid = sorted(state, 1.2);
    Index next = 0;
    for (Index c = 0; c < grid.cluster_count(); ++c) {
        const ClusterGrid::Members members = grid.members(c);
        CHECK(members.first == next);
        CHECK(members.count >= 1);
        CHECK(members.count <= 4);
        CHECK(members.shift == Vec3::Zero());
        next += members.count;
    }
    CHECK(next == atoms);
    Index cluster = 0;
    for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
        CHECK(grid.tiles()[t].first == cluster);
        CHECK(grid.atoms_of_tile(static_cast<Index>(t)).first ==
              (cluster < grid.cluster_count() ? grid.members(cluster).first : atoms));
        cluster = grid.tiles()[t].last;
        const ClusterGrid::Run columns = grid.columns(t);
        CHECK(grid.clusters_of_column(columns.first).first == grid.tiles()[t].first);
        CHECK(grid.clusters_of_column(columns.last - 1).last == grid.tiles()[t].last);
    }
    CHECK(cluster == grid.cluster_count());
    CHECK(grid.tiles().size() >= (atoms > 500 ? 2U : 1U));
}

TEST_CASE("clusters of a column follow each other along z, and their extents hold their atoms") {
    State state = test::random_state(2000, Box(Vec3(9.0, 14.0, 19.0)), 5);
    const ClusterGrid grid = sorted(state, 2.8);
    const auto r = static_cast<const State&>(state).positions();
    bool right = true;
    for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
        for (std::int32_t column = grid.columns(t).first; column < grid.columns(t).last; ++column) {
            double z = 0.0;
            const ClusterGrid::Run clusters = grid.clusters_of_column(column);
            for (Index c = clusters.first; c < clusters.last; ++c) {
                const ClusterGrid::Members members = grid.members(c);
                right = right && (members.count == 4 || c == clusters.last - 1);
                right = right && grid.extent(c).low == r(2, members.first);
                right = right && grid.extent(c).high == r(2, members.first + members.count - 1);
                for (Index i = members.first; i < members.first + members.count; ++i) {
                    right = right && r(2, i) >= z;
                    z = r(2, i);
                }
            }
        }
    }
    CHECK(right);
}

TEST_CASE("a full box wastes few slots, and clusters are no longer than wide") {
    State state = test::shaken_crystal(20, 0.8442, 0.1, 7);
    const ClusterGrid grid = sorted(state, 2.8);
    CHECK(static_cast<double>(grid.cluster_count()) < 1.05 * 32000.0 / 4.0);
    double length = 0.0;
    for (Index c = 0; c < grid.cluster_count(); ++c) {
        length += grid.extent(c).high - grid.extent(c).low;
    }
    CHECK(length / static_cast<double>(grid.cluster_count()) < std::cbrt(4.0 / 0.8442));
}

TEST_CASE(
    "whatever lies within range of a cluster is met, each cluster and image once, and of the tile from one side") {
    const double range = GENERATE(1.2, 2.8, 4.9);  // the last wider than half the box
    const Box box(GENERATE(Vec3(6.0, 6.0, 6.0), Vec3(7.0, 9.0, 16.0), Vec3(30.0, 6.0, 6.0)));
    const double density = GENERATE(0.05, 0.8442);
    State state = test::random_state(static_cast<Index>(density * box.volume()), box, 11);
    const ClusterGrid grid = sorted(state, range);
    const auto r = static_cast<const State&>(state).positions();
    Index missed = 0;
    Index doubled = 0;
    Index wrong_side = 0;
    for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
        for (std::int32_t column = grid.columns(t).first; column < grid.columns(t).last; ++column) {
            const ClusterGrid::Run own = grid.clusters_of_column(column);
            for (Index c = own.first; c < own.last; ++c) {
                const auto [once, both] = met_by(grid, column, c);
                std::vector<int> times(static_cast<std::size_t>(grid.with_images()));
                for (const Index n : once) {
                    ++times[static_cast<std::size_t>(n)];
                    wrong_side += n < grid.tiles()[t].first || n >= grid.tiles()[t].last ? 1 : 0;
                }
                for (const Index n : both) {
                    ++times[static_cast<std::size_t>(n)];
                    wrong_side += n >= grid.tiles()[t].first && n < grid.tiles()[t].last ? 1 : 0;
                }
                const ClusterGrid::Members members = grid.members(c);
                // Images of every atom by up to two edges, against all clusters that are met.
                for (Index other = 0; other < grid.with_images(); ++other) {
                    const ClusterGrid::Members others = grid.members(other);
                    double nearest = 1e9;
                    for (Index i = members.first; i < members.first + members.count; ++i) {
                        for (Index j = others.first; j < others.first + others.count; ++j) {
                            nearest = std::min(nearest, (r.col(i) - r.col(j) - others.shift).norm());
                        }
                    }
                    const bool before = other >= grid.tiles()[t].first && other < c;
                    const int found = times[static_cast<std::size_t>(other)];
                    missed += nearest < range && !before && found == 0 ? 1 : 0;
                    doubled += found > 1 ? 1 : 0;
                }
            }
        }
    }
    CHECK(missed == 0);
    CHECK(doubled == 0);
    CHECK(wrong_side == 0);
}

TEST_CASE("every image of an atom within range of the box is there once, and no other farther away than a cluster") {
    const Box box(Vec3(5.0, 6.5, 11.0));
    const double range = GENERATE(1.0, 2.8, 7.0);
    State state = test::random_state(250, box, 13);
    const ClusterGrid grid = sorted(state, range);
    using Place = std::array<double, 3>;
    std::vector<Place> images;
    for (Index c = grid.cluster_count(); c < grid.with_images(); ++c) {
        const ClusterGrid::Members members = grid.members(c);
        for (Index i = members.first; i < members.first + members.count; ++i) {
            const Vec3 r = static_cast<const State&>(state).positions().col(i) + members.shift;
            images.push_back({r[0], r[1], r[2]});
        }
    }
    std::sort(images.begin(), images.end());
    CHECK(std::adjacent_find(images.begin(), images.end()) == images.end());
    Index missed = 0;
    for (Index i = 0; i < state.count(); ++i) {
        for (int x = -2; x <= 2; ++x) {
            for (int y = -2; y <= 2; ++y) {
                for (int z = -2; z <= 2; ++z) {
                    const Vec3 r =
                        static_cast<const State&>(state).positions().col(i) + Vec3(x, y, z).cwiseProduct(box.edges());
                    const Vec3 outside = (-r).cwiseMax(r - box.edges()).cwiseMax(0.0);
                    const bool wanted = (x != 0 || y != 0 || z != 0) && outside.norm() < range;
                    missed +=
                        wanted && !std::binary_search(images.begin(), images.end(), Place{r[0], r[1], r[2]}) ? 1 : 0;
                }
            }
        }
    }
    CHECK(missed == 0);
}

TEST_CASE("all slots are visited, each once, with its atom and shift or as empty") {
    State state = test::random_state(333, Box(Vec3(6.0, 7.0, 8.0)), 17);
    const ClusterGrid grid = sorted(state, 2.8);
    std::vector<int> times(static_cast<std::size_t>(4 * grid.with_images()));
    bool right = true;
    grid.for_each_slot(
        [&](Index cluster, int k, Index i, const Vec3& shift) {
            const ClusterGrid::Members members = grid.members(cluster);
            right = right && k < members.count && i == members.first + k && shift == members.shift;
            ++times[static_cast<std::size_t>(4 * cluster + k)];
        },
        [&](Index cluster, int k) {
            right = right && k >= grid.members(cluster).count;
            ++times[static_cast<std::size_t>(4 * cluster + k)];
        });
    CHECK(right);
    CHECK(std::count(times.begin(), times.end(), 1) == 4 * grid.with_images());
}

TEST_CASE("a position that is not finite is reported") {
    State state = test::random_state(3, Box(Vec3::Constant(5.0)), 1);
    state.write_positions()(1, 2) = std::numeric_limits<double>::quiet_NaN();
    ClusterGrid grid;
    grid.configure(state.box(), 2.8, 3);
    CHECK_THROWS_AS(grid.sort(state), PhysicsError);
}
