#include "neighbors/tile_order.hpp"

#include <algorithm>
#include <numeric>
#include "catch.hpp"

using namespace ljmd;

namespace {

std::vector<Index> tiles_of(const TileOrder::Part& part) {
    return {part.tiles.begin(), part.tiles.end()};
}

std::vector<std::int64_t> work_of(const TileOrder::Part& part) {
    return {part.work_before.begin(), part.work_before.end()};
}

}  // namespace

TEST_CASE("tiles that need no other rank are summed while messages are under way, half of them each time") {
    TileOrder order;
    order.arrange({true, false, false, true, false, false, true}, std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7}, 1);
    CHECK(tiles_of(order.while_positions_arrive()) == std::vector<Index>{1, 2});
    CHECK(tiles_of(order.with_halo()) == std::vector<Index>{0, 3, 6});
    CHECK(tiles_of(order.while_forces_return()) == std::vector<Index>{4, 5});
    CHECK(work_of(order.while_positions_arrive()) == std::vector<std::int64_t>{0, 2, 5});
    CHECK(work_of(order.with_halo()) == std::vector<std::int64_t>{0, 1, 5, 12});
    CHECK(work_of(order.while_forces_return()) == std::vector<std::int64_t>{0, 5, 11});
}

TEST_CASE("every tile is summed once, and none too early, whatever the number of threads") {
    const int threads = GENERATE(1, 2, 3, 8);
    const std::size_t count = GENERATE(0U, 1U, 2U, 7U, 40U);
    const std::size_t every = GENERATE(1U, 2U, 5U, 100U);  // one tile in so many needs the halo
    std::vector<bool> needs_halo;
    for (std::size_t t = 0; t < count; ++t) {
        needs_halo.push_back(t % every == every - 1);
    }
    TileOrder order;
    for (int turn = 0; turn < 2; ++turn) {  // nothing is left of an earlier order
        order.arrange(needs_halo, std::vector<std::int64_t>(count, 1), threads);
    }
    const std::vector<Index> early = tiles_of(order.while_positions_arrive());
    const std::vector<Index> late = tiles_of(order.while_forces_return());
    std::vector<Index> all = early;
    all.insert(all.end(), late.begin(), late.end());
    for (const Index tile : all) {
        CHECK(!needs_halo[static_cast<std::size_t>(tile)]);
    }
    const std::vector<Index> middle = tiles_of(order.with_halo());
    all.insert(all.end(), middle.begin(), middle.end());
    std::sort(all.begin(), all.end());
    std::vector<Index> expected(count);
    std::iota(expected.begin(), expected.end(), Index{0});
    CHECK(all == expected);
    const bool any = std::find(needs_halo.begin(), needs_halo.end(), true) != needs_halo.end();
    if (any) {
        CHECK(early.size() % static_cast<std::size_t>(threads) == 0);
        CHECK(late.size() == early.size());
    } else {
        CHECK(early.size() == count);
    }
}
