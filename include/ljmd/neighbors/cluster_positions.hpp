#pragma once

#include <type_traits>

#include "ljmd/core/aligned_vector.hpp"
#include "ljmd/core/threads.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"

namespace ljmd {

/// Positions of clusters and images as kernels load them: of cluster c the x of its four slots from place 12 c on, then
/// y, then z.
/// @tparam T  double, or std::int32_t for units of FixedPoint
template <class T>
class ClusterPositions {
  public:
    /// @param place     T(x, axis)
    /// @param distance  T(dx) of whole edges; what images are shifted by
    /// @param far       for slots without an atom
    template <class Place, class Distance>
    void update(const ClusterGrid& clusters, const State& state, Place&& place, Distance&& distance, T far);

    [[nodiscard]] const T* data() const { return positions_.data(); }

  private:
    /// Sums may leave the range of integers where there is no atom.
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
void ClusterPositions<T>::update(const ClusterGrid& clusters, const State& state, Place&& place, Distance&& distance,
                                 T far) {
    constexpr Index slots = ClusterGrid::slots;
    constexpr Index stride = 3 * slots;
    positions_.resize(static_cast<std::size_t>(clusters.with_images() * stride));
    T* const out = positions_.data();
    const double* r = state.positions().data();
    const auto first_atoms = clusters.first_atoms();
    const auto atoms_of = [&](Index cluster) {
        const auto c = static_cast<std::size_t>(cluster);
        return static_cast<Index>(first_atoms[c + 1] - first_atoms[c]);
    };
    const auto fill_up = [&](T* cluster, Index atoms) {
        for (Index k = atoms; k < slots; ++k) {
            cluster[k] = cluster[slots + k] = cluster[2 * slots + k] = far;
        }
    };
    for_each_index(clusters.cluster_count(), [&](Index c) {
        T* to = out + c * stride;
        const double* from = r + 4 * Index{first_atoms[static_cast<std::size_t>(c)]};
        const auto copy = [&](Index k) {
            to[k] = place(from[4 * k], 0);
            to[slots + k] = place(from[4 * k + 1], 1);
            to[2 * slots + k] = place(from[4 * k + 2], 2);
        };
        const Index atoms = atoms_of(c);
        if (atoms == slots) {  // nearly always; and the compiler knows how many there are
            for (Index k = 0; k < slots; ++k) {
                copy(k);
            }
        } else {
            for (Index k = 0; k < atoms; ++k) {
                copy(k);
            }
            fill_up(to, atoms);
        }
    });
    clusters.for_each_images([&](const ClusterGrid::Images& images) {
        T shift[stride];
        for (Index k = 0; k < stride; ++k) {
            shift[k] = distance(images.shift[static_cast<int>(k / slots)]);
        }
        for (Index n = 0; n < images.of.length(); ++n) {
            const T* from = out + (images.of.first + n) * stride;
            T* to = out + (images.first + n) * stride;
            for (Index k = 0; k < stride; ++k) {
                to[k] = sum(from[k], shift[k]);
            }
            fill_up(to, atoms_of(images.of.first + n));
        }
    });
}

}  // namespace ljmd
