#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "execution/ranks.hpp"
#include "ljmd/detail/core/aligned_vector.hpp"
#include "neighbors/cluster_grid.hpp"

namespace ljmd {

/// Where the forces that tiles find for their ghost clusters belong: to atoms of a tile here, or of another rank, which
/// gets them in a message. A tile's atoms take them in the order of the tiles that found them, of all ranks, so that
/// the sums are the same however the tiles are shared.
class GhostRoutes {
  public:
    /// @param ghosts  of each tile  Collective.
    void find(const ClusterGrid& grid, std::span<const std::span<const ClusterGrid::GhostClusters>> ghosts,
              Ranks& ranks);

    /// Forces for consecutive atoms here, three numbers an atom.
    struct Export {
        std::int32_t tile;     ///< whose ghost forces they are among; -1: among other ranks' forces
        std::uint32_t offset;  ///< of their first number there
        std::uint32_t first;   ///< first atom
        std::uint32_t count;
    };
    /// Those for the atoms of a tile, in the order in which they are added.
    [[nodiscard]] std::span<const Export> of_tile(Index tile) const {
        const auto t = static_cast<std::size_t>(tile);
        return std::span(exports_).subspan(starts_[t], starts_[t + 1] - starts_[t]);
    }

    /// Send the forces on ghosts to the ranks that have the atoms, see Ranks::begin_exchange(). Collective.
    /// @param ghost_forces  of each tile, 12 numbers a ghost cluster; only tiles with ghosts of other ranks are read
    void begin_exchange(Ranks& ranks, std::span<const AlignedVector<double>> ghost_forces);
    /// The forces that other ranks have found. @pre Ranks::finish_exchange() has been called
    [[nodiscard]] const double* received() const { return received_.data(); }

  private:
    struct ToRank {
        int rank;
        std::vector<Export> exports;  ///< their tiles and offsets; first is not used
        std::vector<double> forces;   ///< buffer of the message
    };
    struct FromRank {
        int rank;
        std::size_t first;  ///< of its numbers in received_
        std::size_t count;
    };
    std::vector<Export> exports_;      ///< tile by tile
    std::vector<std::size_t> starts_;  ///< each tile's first index in exports_, then the size of that
    std::vector<ToRank> to_;
    std::vector<FromRank> from_;
    AlignedVector<double> received_;
};

}  // namespace ljmd
