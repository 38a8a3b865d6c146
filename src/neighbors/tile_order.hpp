#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// In which order a rank sums the forces of its tiles, so that messages are under way meanwhile: while positions
/// arrive, tiles that have no ghost clusters of other ranks; then those that have; and while the forces on these ghosts
/// are sent, the rest. No sum depends on the order.
class TileOrder {
  public:
    /// @param needs_halo  of each tile: whether it has ghost clusters of other ranks
    /// @param work        of each tile, in any unit
    /// @param threads     that share the tiles: if any tile needs the halo, the first and the last part have a multiple
    /// of it; else all tiles are in the first
    void arrange(const std::vector<bool>& needs_halo, std::span<const std::int64_t> work, int threads);

    struct Part {
        std::span<const Index> tiles;
        std::span<const std::int64_t> work_before;  ///< see ThreadTeam::for_each_block()
    };
    [[nodiscard]] Part while_positions_arrive() const { return part(0); }
    [[nodiscard]] Part with_halo() const { return part(1); }
    [[nodiscard]] Part while_forces_return() const { return part(2); }

  private:
    struct Tiles {
        std::vector<Index> tiles;
        std::vector<std::int64_t> work_before;
    };
    [[nodiscard]] Part part(std::size_t k) const { return {parts_[k].tiles, parts_[k].work_before}; }

    std::array<Tiles, 3> parts_;
};

}  // namespace ljmd
