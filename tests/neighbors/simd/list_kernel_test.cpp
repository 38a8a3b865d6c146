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

TEST_CASE("on a list stands every cluster with an atom in range, no other, and of the tile only later ones as once") {
    State state = test::random_state(900, cubic_box(900, 0.8442), 23);
    VerletList list(0.3);
    list.prepare_for(default_simd_level(), 1);
    list.prepare(state, 2.5);
    const ClusterGrid& grid = list.clusters();
    const auto r = static_cast<const State&>(state).positions();
    const auto nearest = [&](Index i, Index cluster) {
        const ClusterGrid::Members members = grid.members(cluster);
        double d = 1e9;
        for (Index j = members.first; j < members.first + members.count; ++j) {
            d = std::min(d, (r.col(i) - r.col(j) - members.shift).norm());
        }
        return d;
    };
    Index lists = 0;
    bool right = true;
    for (std::size_t t = 0; t < list.tiles().size(); ++t) {
        const auto& [entries, starts] = list.tiles()[t];
        const ClusterGrid::Run of_tile = grid.tiles()[t];
        const std::uint32_t* row = starts.data();
        for (Index own = of_tile.first; own < of_tile.last; ++own) {
            const ClusterGrid::Members atoms = grid.members(own);
            for (Index i = atoms.first; i < atoms.first + atoms.count; ++i, row += 2, ++lists) {
                std::vector<int> times(static_cast<std::size_t>(grid.with_images()));
                for (std::uint32_t e = row[0]; e < row[2]; ++e) {
                    const Index cluster = entries[e] / 12;
                    const bool later = cluster > own && cluster < of_tile.last;
                    right = right && entries[e] % 12 == 0 && (e < row[1]) == later;
                    ++times[static_cast<std::size_t>(cluster)];
                }
                for (Index cluster = 0; cluster < grid.with_images(); ++cluster) {
                    const bool before = cluster >= of_tile.first && cluster <= own;
                    const double d = nearest(i, cluster);
                    if (std::abs(d - 2.8) > 1e-6) {  // the kernel computes in single precision
                        right = right && times[static_cast<std::size_t>(cluster)] == (!before && d < 2.8 ? 1 : 0);
                    }
                }
            }
        }
    }
    CHECK(lists == 900);
    CHECK(right);
}
