#include <catch2/catch.hpp>

#include "core/thread_guard.hpp"
#include "ljmd/neighbors/verlet_list.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

TEST_CASE("list kernels of every SIMD level find the pairs of all-pairs, for any filling and number of threads") {
    const int lanes = GENERATE(1, 4, 16);
    const int threads = GENERATE(1, 3);
    const test::ThreadGuard guard(threads);
    for (const double density : {0.02, 0.8442, 1.3}) {
        State state = test::random_state(400, cubic_box(400, density), 19);
        const auto expected = test::all_pairs_within(state, 2.5);
        for (const SimdLevel level : usable_simd_levels()) {
            CAPTURE(name(level), lanes, threads, density);
            VerletList list(0.3);
            list.prepare_for(level, lanes);
            list.prepare(state, 2.5);
            CHECK(test::pairs_within(list, state, 2.5) == expected);
        }
    }
}

TEST_CASE("lists are filled up to whole vectors with the far point, and none is empty") {
    State state = test::random_state(100, Box(Vec3::Constant(9.0)), 23);
    VerletList list(0.3);
    list.prepare_for(default_simd_level(), 8);
    list.prepare(state, 2.5);
    Index neighbors = 0;
    for (std::size_t b = 0; b < list.blocks().size(); ++b) {
        const VerletList::Block& block = list.blocks()[b];
        const Index atoms = std::min<Index>(100 - 64 * static_cast<Index>(b), 64);
        for (std::size_t k = 0; k < static_cast<std::size_t>(atoms); ++k) {
            const std::uint32_t first = block.starts[k];
            const std::uint32_t last = block.starts[k + 1];
            REQUIRE(last > first);
            REQUIRE((last - first) % 8 == 0);
            bool filling = false;
            for (std::uint32_t e = first; e < last; ++e) {
                const bool far = block.entries[e] == 4 * state.far_point();
                REQUIRE((far || !filling));  // nothing follows the filling
                filling = far;
                neighbors += far ? 0 : 1;
            }
        }
    }
    CHECK(neighbors == list.entries());
}
