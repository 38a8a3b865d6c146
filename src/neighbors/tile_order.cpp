#include "neighbors/tile_order.hpp"

#include <algorithm>

namespace ljmd {

void TileOrder::arrange(const std::vector<bool>& needs_halo, std::span<const std::int64_t> work, int threads) {
    const auto inner = static_cast<Index>(std::count(needs_halo.begin(), needs_halo.end(), false));
    const auto all = static_cast<Index>(needs_halo.size());
    // Where nothing is exchanged, one loop.
    const Index early = inner == all ? all : inner / 2 / threads * threads;
    for (Tiles& part : parts_) {
        part.tiles.clear();
        part.work_before.assign(1, 0);
    }
    Index inner_so_far = 0;
    for (Index tile = 0; tile < all; ++tile) {
        const auto t = static_cast<std::size_t>(tile);
        std::size_t number = 1;
        if (!needs_halo[t]) {
            number = inner_so_far < early ? 0 : inner_so_far < 2 * early ? 2 : 1;
            ++inner_so_far;
        }
        parts_[number].tiles.push_back(tile);
        parts_[number].work_before.push_back(parts_[number].work_before.back() + work[t]);
    }
}

}  // namespace ljmd
