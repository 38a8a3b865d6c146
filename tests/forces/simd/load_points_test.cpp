#include "forces/simd/load_points.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <vector>

#include "ljmd/core/aligned_vector.hpp"

using namespace ljmd;

TEMPLATE_TEST_CASE_SIG("scattered points become vectors of x, y and z, each point in one lane", "",
                       ((class T, int lanes), T, lanes), (double, 2), (double, 4), (double, 8), (std::int32_t, 4),
                       (std::int32_t, 8), (std::int32_t, 16)) {
    AlignedVector<T> points(4 * 50);
    std::iota(points.begin(), points.end(), T(1000));
    std::array<std::int32_t, static_cast<std::size_t>(lanes)> entries{};
    std::mt19937 generator(3);
    for (auto& entry : entries) {
        entry = static_cast<std::int32_t>(4 * (generator() % 50));
    }
    const auto loaded = simd::load_points<T, lanes>(points.data(), entries.data());
    std::vector<T> met;
    for (int k = 0; k < lanes; ++k) {
        CHECK(loaded.y[k] == loaded.x[k] + 1);
        CHECK(loaded.z[k] == loaded.x[k] + 2);
        met.push_back(loaded.x[k]);
    }
    std::vector<T> wanted;
    for (const std::int32_t entry : entries) {
        wanted.push_back(points[static_cast<std::size_t>(entry)]);
    }
    CHECK_THAT(met, Catch::UnorderedEquals(wanted));
}
