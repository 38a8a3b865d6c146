#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "neighbors/sample_states.hpp"
#include "neighbors/verlet_list.hpp"

using namespace ljmd;

TEST_CASE("list kernels of every SIMD level find the pairs of all-pairs, for any shape of rows and number of threads") {
    const RowShape shape = GENERATE(RowShape{1, 2}, RowShape{2, 2}, RowShape{2, 4}, RowShape{4, 4});
    const int threads = GENERATE(1, 3);
    for (const double density : {0.02, 0.8442, 1.3}) {
        State state = test::random_state(400, cubic_box(400, density), 19, test::with_threads(threads));
        const auto expected = test::all_pairs_within(state, 2.5);
        for (const SimdLevel level : usable_simd_levels()) {
            CAPTURE(name(level), shape.atoms, shape.others, threads, density);
            VerletList list(0.3);
            list.prepare_for(level, shape);
            list.prepare(state, 2.5);
            CHECK(test::pairs_within(list, state, 2.5) == expected);
        }
    }
}

TEST_CASE(
    "on a list stands every part of ghosts and later clusters of the tile with an atom in range, its own half first") {
    constexpr Index part = 2;
    State state = test::random_state(900, cubic_box(900, 0.8442), 23);
    VerletList list(0.3);
    list.prepare_for(default_simd_level(), {1, part});
    list.prepare(state, 2.5);
    const ClusterGrid& grid = list.clusters();
    const auto r = static_cast<const State&>(state).positions();
    struct Members {
        AtomRange atoms;
        Vec3 shift;
    };
    Index lists = 0;
    bool right = true;
    for (std::size_t t = 0; t < list.tiles().size(); ++t) {
        const VerletList::Tile& tile = list.tiles()[t];
        std::vector<Members> clusters;
        for (Index own = grid.tiles()[t].first; own < grid.tiles()[t].last; ++own) {
            clusters.push_back({grid.atoms_of_cluster(own), Vec3::Zero()});
        }
        const auto own_count = static_cast<Index>(clusters.size());
        for (const ClusterGrid::GhostClusters& ghosts : tile.ghosts) {
            for (Index ghost = ghosts.of.first; ghost < ghosts.of.last; ++ghost) {
                clusters.push_back({grid.atoms_of_cluster(ghost), ghosts.shift});
            }
        }
        REQUIRE(static_cast<std::int32_t>(clusters.size()) == tile.cluster_count);
        const auto nearest = [&](Index i, const Members& members, Index slot) {
            double d = 1e9;
            const Index first = members.atoms.first + slot;
            for (Index j = first; j < std::min(members.atoms.last, first + part); ++j) {
                d = std::min(d, (r.col(i) - r.col(j) - members.shift).norm());
            }
            return d;
        };
        const std::uint32_t* row = tile.starts.data();
        for (Index own = 0; own < own_count; ++own) {
            const AtomRange atoms = clusters[static_cast<std::size_t>(own)].atoms;
            for (Index i = atoms.first; i < atoms.last; ++i, row += 2, ++lists) {
                const Index half = (i - atoms.first) / part * part;  // in which the atom itself lies
                std::vector<int> times(12 * clusters.size());
                for (std::uint32_t e = row[0]; e < row[2]; ++e) {
                    ++times.at(static_cast<std::size_t>(tile.entries[e]));
                    right = right && (tile.entries[e] % 12 == half) == (e < row[1]);
                }
                for (Index place = 0; place < Index{12} * tile.cluster_count; ++place) {
                    const Index cluster = place / 12;
                    const Index slot = place % 12;
                    const double d =
                        slot == 0 || slot == part ? nearest(i, clusters[static_cast<std::size_t>(cluster)], slot) : 1e9;
                    if (cluster == own) {
                        const bool other_half = half == 0 && slot == part && atoms.count() > part;
                        right = right && times[static_cast<std::size_t>(place)] == (other_half ? 1 : 0);
                    } else if (std::abs(d - 2.8) > 1e-6) {  // the kernel computes in single precision
                        right = right && times[static_cast<std::size_t>(place)] == (cluster > own && d < 2.8 ? 1 : 0);
                    }
                }
            }
        }
    }
    CHECK(lists == 900);
    CHECK(right);
}
