#include "ljmd/detail/reference/freezing.hpp"

#include <array>
#include <cmath>

namespace ljmd {

namespace {

/// Coefficients of b^0 to b^5.
using Coefficients = std::array<double, 6>;

constexpr Coefficients fluid{0.90735, -0.27120, 0.91784, -1.16270, 0.68012, -0.15284};
constexpr Coefficients crystal{0.908629, -0.041510, 0.514632, -0.708590, 0.428351, -0.095229};

double density(const Coefficients& coefficients, double temperature) {
    const double b = 1.0 / temperature;
    double sum = 0.0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
        sum = sum * b + *c;
    }
    return sum / std::sqrt(std::sqrt(b));
}

}  // namespace

std::optional<FreezingDensities> freezing_densities(double temperature) {
    if (!(temperature >= triple_point_temperature && temperature <= highest_freezing_temperature)) {
        return std::nullopt;
    }
    return FreezingDensities{density(fluid, temperature), density(crystal, temperature)};
}

}  // namespace ljmd
