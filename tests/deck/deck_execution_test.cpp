#include "deck/deck_execution.hpp"

#include "core/environment_guard.hpp"
#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("threads and SIMD level are those that are asked for, the precision is the deck's") {
    const DeckFolder folder(small_deck);
    const ExecutionOptions options = execution_options(folder.load(), 3, "portable");
    CHECK(options.threads == 3);
    CHECK(options.simd == SimdLevel::portable);
    CHECK(options.precision == Precision::double_precision);
    CHECK(execution_options(folder.load({"performance.precision=mixed"})).precision == Precision::mixed);
    CHECK(execution_options(DeckFolder(stars_deck).load()).precision == Precision::double_precision);
}

TEST_CASE("what is not asked for is taken from the environment") {
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    const EnvironmentGuard threads("OMP_NUM_THREADS", "2");
    const EnvironmentGuard level("LJMD_SIMD", "portable");
    CHECK(execution_options(deck).threads == 2);
    CHECK(execution_options(deck).simd == SimdLevel::portable);
    CHECK(execution_options(deck, 1).threads == 1);
}

TEST_CASE("wrong values are errors where they are asked for, and only there") {
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    CHECK_THROWS_AS(execution_options(deck, 1, "fastest"), InputError);
    const EnvironmentGuard threads("OMP_NUM_THREADS", "many");
    const EnvironmentGuard level("LJMD_SIMD", "fastest");
    CHECK_THROWS_AS(execution_options(deck, 0, "portable"), InputError);
    CHECK_THROWS_AS(execution_options(deck, 1), InputError);
    CHECK_NOTHROW(execution_options(deck, 1, "portable"));
}
