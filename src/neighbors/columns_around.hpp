#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ljmd/core/types.hpp"
#include "neighbors/cluster_grid.hpp"

namespace ljmd {

/// The columns of a ClusterGrid around a point, and images of them.
class ColumnsAround {
  public:
    explicit ColumnsAround(const ClusterGrid& grid) : grid_(grid) {}

    /// Call visit(column, shift) for each column here, or image of one, that may hold a point within a radius of a
    /// centre, until a call returns true. The shift is the displacement of the image: whole box edges [sigma].
    /// @param center  anywhere [sigma]  @return whether a call returned true
    template <class Visit>
    bool any(const Vec3& center, double radius, Visit&& visit);

  private:
    /// Contribution of one cell along an axis to the place, shift and squared distance of the columns there.
    struct Layer {
        ClusterGrid::Place place;
        double shift;
        double gap2;
    };
    void look_along(std::size_t axis, double center, double radius);

    const ClusterGrid& grid_;
    std::array<std::vector<Layer>, 3> layers_;
};

template <class Visit>
bool ColumnsAround::any(const Vec3& center, double radius, Visit&& visit) {
    for (std::size_t a = 0; a < 3; ++a) {
        look_along(a, center[static_cast<Index>(a)], radius);
    }
    const auto& [along_x, along_y, along_z] = layers_;
    for (const Layer& y : along_y) {
        for (const Layer& x : along_x) {
            if (x.gap2 + y.gap2 > radius * radius) {
                continue;
            }
            for (const Layer& z : along_z) {
                const std::int32_t column = grid_.column_at(x.place + y.place + z.place);
                if (column >= 0 && visit(column, Vec3(x.shift, y.shift, z.shift))) {
                    return true;
                }
            }
        }
    }
    return false;
}

}  // namespace ljmd
