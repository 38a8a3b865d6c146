#include "observables/simd/cosine_kernel.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "ljmd/detail/core/aligned_vector.hpp"

using namespace ljmd;

TEST_CASE("every level adds up the same cosines, each of them right to 3e-13") {
    const Index count = 57;
    AlignedVector<double> r(static_cast<std::size_t>(4 * count));
    std::mt19937_64 generator(8);
    std::uniform_real_distribution<double> uniform(-30.0, 30.0);
    for (double& x : r) {
        x = uniform(generator);
    }
    r[0] = 0.0;
    r[1] = -0.25;
    const double turns[4] = {1.0, 2.0, 0.3, 0.0};
    const double start[4] = {0.0, 0.3, -0.45, 0.0};
    double before[4] = {};
    for (const SimdLevel level : usable_simd_levels()) {
        CAPTURE(name(level));
        for (Index n = 0; n <= count; ++n) {
            double sums[4] = {9.0, 9.0, 9.0, 9.0};
            cosine_kernel(level).sums_of_cosines(r.data(), n, turns, start, sums);
            for (std::size_t a = 0; a < 4; ++a) {
                double expected = 0.0;
                for (Index i = 0; i < n; ++i) {
                    const double x = turns[a] * r[static_cast<std::size_t>(4 * i) + a] - start[a];
                    expected += std::cos(2.0 * std::numbers::pi * x);
                }
                CHECK(sums[a] == Approx(expected).epsilon(0.0).margin(3e-13 * static_cast<double>(n)));
                if (n == count) {
                    CHECK((level == usable_simd_levels().front() || sums[a] == before[a]));
                    before[a] = sums[a];
                }
            }
        }
    }
}
