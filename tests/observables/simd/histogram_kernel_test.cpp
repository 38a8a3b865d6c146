#include "observables/simd/histogram_kernel.hpp"

#include <cmath>
#include <random>
#include <vector>
#include "catch.hpp"

#include "ljmd/detail/execution/simd.hpp"
#include "ljmd/model/box.hpp"

using namespace ljmd;

TEST_CASE(
    "every level finds the bins that distances fall into, and those behind the last one in turn when they lie beyond") {
    const SimdLevel level = GENERATE(from_range(usable_simd_levels()));
    CAPTURE(name(level));
    const HistogramKernel kernel = histogram_kernel(level);
    constexpr std::size_t points = 37;
    const Vec3 edges(5.0, 6.0, 8.0);
    std::mt19937_64 generator(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> x(points);
    std::vector<double> y(points);
    std::vector<double> z(points);
    for (std::size_t k = 0; k < points; ++k) {
        x[k] = edges[0] * uniform(generator);
        y[k] = edges[1] * uniform(generator);
        z[k] = edges[2] * uniform(generator);
    }
    const Vec3 r(0.5, 5.5, 0.25);
    x[5] = r[0];
    y[5] = r[1];
    z[5] = r[2];
    x[6] = edges[0];  // rounding may put an atom onto the wall
    y[6] = r[1];
    z[6] = r[2];
    for (std::size_t count = 0; count <= points; ++count) {
        std::vector<std::int32_t> bins(points, -1);
        kernel.bins_of({x.data(), y.data(), z.data(), static_cast<int>(count)}, r.data(), edges.data(), 4.0, 8,
                       bins.data());
        for (std::size_t k = 0; k < points; ++k) {
            const double distance = Box(edges).minimum_image(r - Vec3(x[k], y[k], z[k])).norm();
            const auto beyond = 8 + static_cast<std::int32_t>(k) % HistogramKernel::overflow_bins;
            const std::int32_t expected = distance < 2.0 ? static_cast<std::int32_t>(4.0 * distance) : beyond;
            CHECK(bins[k] == (k < count ? expected : -1));
        }
    }
}
