#include <catch2/catch.hpp>

#include "core/thread_guard.hpp"
#include "ljmd/neighbors/verlet_list.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

TEST_CASE("list kernels of every SIMD level find the pairs of all-pairs, for any width of rows and number of threads") {
    const int atoms_per_row = GENERATE(1, 2, 4);
    const int threads = GENERATE(1, 3);
    const test::ThreadGuard guard(threads);
    for (const double density : {0.02, 0.8442, 1.3}) {
        State state = test::random_state(400, cubic_box(400, density), 19);
        const auto expected = test::all_pairs_within(state, 2.5);
        for (const SimdLevel level : usable_simd_levels()) {
            CAPTURE(name(level), atoms_per_row, threads, density);
            VerletList list(0.3);
            list.prepare_for(level, atoms_per_row);
            list.prepare(state, 2.5);
            CHECK(test::pairs_within(list, state, 2.5) == expected);
        }
    }
}

TEST_CASE("on a list stands every guest and every later cluster of the tile with an atom in range, and no other") {
    State state = test::random_state(900, cubic_box(900, 0.8442), 23);
    VerletList list(0.3);
    list.prepare_for(default_simd_level(), 1);
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
        for (const ClusterGrid::Guests& guests : tile.guests) {
            for (Index guest = guests.of.first; guest < guests.of.last; ++guest) {
                clusters.push_back({grid.atoms_of_cluster(guest), guests.shift});
            }
        }
        REQUIRE(static_cast<std::int32_t>(clusters.size()) == tile.cluster_count);
        const auto nearest = [&](Index i, const Members& members) {
            double d = 1e9;
            for (Index j = members.atoms.first; j < members.atoms.last; ++j) {
                d = std::min(d, (r.col(i) - r.col(j) - members.shift).norm());
            }
            return d;
        };
        const std::uint32_t* row = tile.starts.data();
        for (Index own = 0; own < own_count; ++own) {
            const AtomRange atoms = clusters[static_cast<std::size_t>(own)].atoms;
            for (Index i = atoms.first; i < atoms.last; ++i, ++row, ++lists) {
                std::vector<int> times(clusters.size());
                for (std::uint32_t e = row[0]; e < row[1]; ++e) {
                    right = right && tile.entries[e] % 12 == 0;
                    ++times.at(static_cast<std::size_t>(tile.entries[e] / 12));
                }
                for (Index cluster = 0; cluster < tile.cluster_count; ++cluster) {
                    const double d = nearest(i, clusters[static_cast<std::size_t>(cluster)]);
                    if (std::abs(d - 2.8) > 1e-6) {  // the kernel computes in single precision
                        right = right && times[static_cast<std::size_t>(cluster)] == (cluster > own && d < 2.8 ? 1 : 0);
                    }
                }
            }
        }
    }
    CHECK(lists == 900);
    CHECK(right);
}
