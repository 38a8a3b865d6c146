#include "observables/simd/histogram_kernel.hpp"

#include <cmath>

namespace ljmd {

namespace {

/// Distance of two coordinates in a periodic box.
inline double shortest(double a, double b, double edge) {
    const double d = std::fabs(a - b);
    const double other = edge - d;
    return d < other ? d : other;
}

// A loop without branches, which compilers vectorise: half of the pairs lie beyond the histogram, unpredictably.
void bins_of(const HistogramKernel::Points& points, const double* r, const double* edges, double per_length,
             std::int32_t overflow, std::int32_t* out) {
    const HistogramKernel::Points p = points;
    const double r_x = r[0], r_y = r[1], r_z = r[2];
    const double edge_x = edges[0], edge_y = edges[1], edge_z = edges[2];
    const double last = overflow;
    for (int k = 0; k < p.count; ++k) {
        const double dx = shortest(r_x, p.x[k], edge_x);
        const double dy = shortest(r_y, p.y[k], edge_y);
        const double dz = shortest(r_z, p.z[k], edge_z);
        const double bin = std::sqrt(dx * dx + dy * dy + dz * dz) * per_length;
        const auto beyond = overflow + k % HistogramKernel::overflow_bins;
        out[k] = bin < last ? static_cast<std::int32_t>(bin) : beyond;
    }
}

}  // namespace

template <>
HistogramKernel simd::compiled_here<HistogramKernel, simd::LJMD_SIMD_LEVEL>() {
    return {bins_of};
}

}  // namespace ljmd
