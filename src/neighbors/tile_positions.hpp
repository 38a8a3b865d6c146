#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

#include "core/prefetch.hpp"
#include "ljmd/detail/core/aligned_vector.hpp"
#include "ljmd/detail/model/state.hpp"
#include "neighbors/cluster_grid.hpp"

namespace ljmd {

/// Positions of a tile's own and ghost clusters, as kernels load them: cluster c begins at index 12 c with the x of its
/// four slots, then y, then z [sigma, or units of FixedPoint].
/// @tparam T  double, or std::int32_t for units of FixedPoint
template <class T>
class TilePositions {
  public:
    /// @param count     number of clusters, ghosts included
    /// @param place     T(x, axis): converts a coordinate
    /// @param distance  T(dx): converts the shift of an image, whole box edges
    /// @param far       coordinate for slots without an atom
    template <class Place, class Distance>
    void update(const ClusterGrid& grid, const ClusterGrid::Run& own,
                std::span<const ClusterGrid::GhostClusters> ghosts, Index count, const State& state, Place&& place,
                Distance&& distance, T far);

    [[nodiscard]] const T* data() const { return positions_.data(); }

  private:
    /// Unsigned, because integer sums may overflow.
    static T sum(T a, T b) {
        if constexpr (std::is_integral_v<T>) {
            using Unsigned = std::make_unsigned_t<T>;
            return static_cast<T>(static_cast<Unsigned>(a) + static_cast<Unsigned>(b));
        } else {
            return a + b;
        }
    }

    AlignedVector<T> positions_;
};

template <class T>
template <class Place, class Distance>
void TilePositions<T>::update(const ClusterGrid& grid, const ClusterGrid::Run& own,
                              std::span<const ClusterGrid::GhostClusters> ghosts, Index count, const State& state,
                              Place&& place, Distance&& distance, T far) {
    constexpr Index slots = ClusterGrid::slots;
    constexpr Index stride = 3 * slots;
    positions_.resize(std::max(positions_.size(), static_cast<std::size_t>(count * stride)));
    const double* r = state.positions().data();
    const auto first_atoms = grid.first_atoms();
    const auto copy = [&](const ClusterGrid::Run& clusters, T* to, T dx, T dy, T dz) {
        for (auto c = static_cast<std::size_t>(clusters.first); c < static_cast<std::size_t>(clusters.last);
             ++c, to += stride) {
            const double* from = r + vector_stride * Index{first_atoms[c]};
            const auto copy_atom = [&](Index k) {
                to[k] = sum(place(from[vector_stride * k], 0), dx);
                to[slots + k] = sum(place(from[vector_stride * k + 1], 1), dy);
                to[2 * slots + k] = sum(place(from[vector_stride * k + 2], 2), dz);
            };
            const auto atoms = static_cast<Index>(first_atoms[c + 1] - first_atoms[c]);
            if (atoms == slots) {  // nearly always; lets the compiler unroll the loop
                for (Index k = 0; k < slots; ++k) {
                    copy_atom(k);
                }
            } else {
                for (Index k = 0; k < atoms; ++k) {
                    copy_atom(k);
                }
                for (Index k = atoms; k < slots; ++k) {
                    to[k] = to[slots + k] = to[2 * slots + k] = far;
                }
            }
        }
    };
    copy(own, positions_.data(), T{}, T{}, T{});
    // Ghosts lie here and there. In large systems none is in a cache.
    constexpr std::size_t ahead = 4;
    for (std::size_t g = 0; g < ghosts.size(); ++g) {
        const ClusterGrid::GhostClusters& run = ghosts[g];
        if (g + ahead < ghosts.size()) {
            const AtomRange soon = grid.atoms_of(ghosts[g + ahead].of);
            prefetch(r + vector_stride * soon.first, r + vector_stride * soon.last);
        }
        copy(run.of, positions_.data() + run.first * stride, distance(run.shift[0]), distance(run.shift[1]),
             distance(run.shift[2]));
    }
}

}  // namespace ljmd
