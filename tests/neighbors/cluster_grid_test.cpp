#include "neighbors/cluster_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>
#include "catch.hpp"

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

/// Two clusters, of the same number or not, and how many edges the second is away. Each pair has one name only.
using Meeting = std::tuple<Index, Index, std::array<int, 3>>;

Meeting meeting(Index first, Index second, std::array<int, 3> edges) {
    const std::array<int, 3> back{-edges[0], -edges[1], -edges[2]};
    return std::min(Meeting{first, second, edges}, Meeting{second, first, back});
}

std::array<int, 3> in_edges(const Vec3& shift, const Box& box) {
    const Vec3 edges = shift.cwiseQuotient(box.edges());
    return {static_cast<int>(std::lround(edges[0])), static_cast<int>(std::lround(edges[1])),
            static_cast<int>(std::lround(edges[2]))};
}

/// How often each two clusters meet. Clusters of a tile are shown to those before them, too: left out here.
std::map<Meeting, int> meetings(const ClusterGrid& grid, const Box& box) {
    std::map<Meeting, int> met;
    std::vector<ClusterGrid::Near> near;
    for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
        const ClusterGrid::Neighborhood tile = grid.neighborhood(t);
        for (std::int32_t column = grid.columns(t).first; column < grid.columns(t).last; ++column) {
            grid.find_near(tile, column, near);
            const ClusterGrid::Run own = grid.clusters_of_column(column);
            for (Index c = own.first; c < own.last; ++c) {
                for (const ClusterGrid::Near& other : near) {
                    if (grid.is_out_of_reach(other, grid.extent(c))) {
                        break;
                    }
                    const ClusterGrid::Run window = grid.window(other, grid.extent(c));
                    for (Index n = window.first; n < window.last; ++n) {
                        if (!other.column.ghost) {
                            if (n > c) {
                                ++met[meeting(c, n, {0, 0, 0})];
                            }
                            continue;
                        }
                        for (const ClusterGrid::GhostClusters& ghosts : tile.ghosts()) {
                            const Index number = n + other.column.offset - ghosts.first;
                            if (number >= 0 && number < ghosts.of.length()) {
                                ++met[meeting(c, ghosts.of.first + number, in_edges(ghosts.shift, box))];
                            }
                        }
                    }
                }
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
        const AtomRange members = grid.atoms_of_cluster(c);
        CHECK(members.first == next);
        CHECK(members.count() >= 1);
        CHECK(members.count() <= 4);
        next += members.count();
    }
    CHECK(next == atoms);
    Index cluster = 0;
    for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
        CHECK(grid.tiles()[t].first == cluster);
        CHECK(grid.atoms_of_tile(static_cast<Index>(t)).first ==
              (cluster < grid.cluster_count() ? grid.atoms_of_cluster(cluster).first : atoms));
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
                const AtomRange members = grid.atoms_of_cluster(c);
                right = right && (members.count() == 4 || c == clusters.last - 1);
                right = right && grid.extent(c).low == r(2, members.first);
                right = right && grid.extent(c).high == r(2, members.last - 1);
                for (Index i = members.first; i < members.last; ++i) {
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

TEST_CASE("any two clusters within range of each other meet, images included, and no two meet twice") {
    const double range = GENERATE(1.2, 2.8, 4.9);  // the last wider than half the box
    const Box box(GENERATE(Vec3(6.0, 6.0, 6.0), Vec3(7.0, 9.0, 16.0), Vec3(30.0, 6.0, 6.0)));
    const double density = GENERATE(0.05, 0.8442);
    State state = test::random_state(static_cast<Index>(density * box.volume()), box, 11);
    const ClusterGrid grid = sorted(state, range);
    const auto r = static_cast<const State&>(state).positions();
    const std::map<Meeting, int> met = meetings(grid, box);
    Index missed = 0;
    const auto check = [&](Index first, Index second, const std::array<int, 3>& edges) {
        const Vec3 shift = Vec3(edges[0], edges[1], edges[2]).cwiseProduct(box.edges());
        const AtomRange one = grid.atoms_of_cluster(first);
        const AtomRange other = grid.atoms_of_cluster(second);
        double nearest = 1e9;
        for (Index i = one.first; i < one.last; ++i) {
            for (Index j = other.first; j < other.last; ++j) {
                nearest = std::min(nearest, (r.col(i) - r.col(j) - shift).norm());
            }
        }
        missed += nearest < range && !met.contains(meeting(first, second, edges)) ? 1 : 0;
    };
    for (Index first = 0; first < grid.cluster_count(); ++first) {
        for (Index second = first; second < grid.cluster_count(); ++second) {
            for (int x = -1; x <= 1; ++x) {
                for (int y = -1; y <= 1; ++y) {
                    for (int z = -1; z <= 1; ++z) {
                        if (first != second || std::tie(x, y, z) > std::tuple(0, 0, 0)) {
                            check(first, second, {x, y, z});
                        }
                    }
                }
            }
        }
    }
    CHECK(missed == 0);
    CHECK(std::all_of(met.begin(), met.end(), [](const auto& entry) { return entry.second == 1; }));
}

TEST_CASE("ghosts are numbered behind a tile's own clusters, and those that stand together are of one column") {
    State state = test::random_state(900, Box(Vec3(7.0, 9.0, 16.0)), 13);
    const ClusterGrid grid = sorted(state, 2.8);
    REQUIRE(grid.tiles().size() > 1);
    for (std::size_t t = 0; t < grid.tiles().size(); ++t) {
        const ClusterGrid::Neighborhood tile = grid.neighborhood(t);
        CHECK(tile.own().first == grid.tiles()[t].first);
        CHECK(tile.own().last == grid.tiles()[t].last);
        std::int32_t next = tile.own().length();
        bool together = true;
        for (const ClusterGrid::GhostClusters& ghosts : tile.ghosts()) {
            CHECK(ghosts.first == next);
            next += ghosts.of.length();
            for (Index c = ghosts.of.first + 1; c < ghosts.of.last; ++c) {
                together = together && grid.extent(c).low >= grid.extent(c - 1).high;
            }
        }
        CHECK(together);
        CHECK(next == tile.cluster_count());
        CHECK(next > tile.own().length());
    }
}

TEST_CASE("a position that is not finite is reported") {
    State state = test::random_state(3, Box(Vec3::Constant(5.0)), 1);
    state.write_positions()(1, 2) = std::numeric_limits<double>::quiet_NaN();
    ClusterGrid grid;
    grid.configure(state.box(), 2.8, 3);
    CHECK_THROWS_AS(grid.sort(state), PhysicsError);
}
