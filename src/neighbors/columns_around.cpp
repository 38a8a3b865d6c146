#include "neighbors/columns_around.hpp"

#include <algorithm>
#include <cmath>

namespace ljmd {

void ColumnsAround::look_along(std::size_t axis, double center, double radius) {
    const auto a = static_cast<Index>(axis);
    const auto cell_of = [&](double x) { return static_cast<int>(std::floor(x * grid_.inverse_width_[a])); };
    const double width = 1.0 / grid_.inverse_width_[a];
    const int last = cell_of(center + radius);
    layers_[axis].clear();
    for (int cell = cell_of(center - radius); cell <= last; ++cell) {
        const int boxes = grid_.boxes_away(cell, axis);
        const auto in_box = static_cast<std::size_t>(cell - boxes * grid_.cells_[axis]);
        const double gap = std::max({cell * width - center, center - (cell + 1) * width, 0.0});
        layers_[axis].push_back({grid_.places_along_[axis][in_box], boxes * grid_.edges_[a], gap * gap});
    }
}

}  // namespace ljmd
