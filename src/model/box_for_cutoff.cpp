#include "model/box_for_cutoff.hpp"

namespace ljmd {

namespace {

constexpr double rounding = 1e-12;  // fraction of an edge

}  // namespace

Box box_for_cutoff(const Box& box, double cutoff) {
    Vec3 edges = box.edges();
    for (double& edge : edges) {
        const double wanted = 2.0 * cutoff;
        if (edge < wanted && edge >= (1.0 - rounding) * wanted) {
            edge = wanted + box.resolution();  // rounding to the grid cannot bring it below `wanted`
        }
    }
    return Box(edges);
}

}  // namespace ljmd
