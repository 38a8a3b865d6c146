#include "ljmd/potentials/second_virial.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/quadrature.hpp"
#include "core/roots.hpp"

namespace ljmd {

namespace {

/// @param u       pair energy as a function of r
/// @param breaks  in ascending order: 0, points where u is not smooth or changes fast, and the end
template <class Energy>
double virial_integral(Energy&& u, double temperature, const std::vector<double>& breaks) {
    const auto mayer = [&](double r) { return std::expm1(-u(r) / temperature) * r * r; };
    double sum = 0.0;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        sum += integrate(mayer, breaks[i - 1], breaks[i]);
    }
    return -2.0 * std::numbers::pi * sum;
}

}  // namespace

double second_virial_coefficient(const PairPotential& potential, double temperature) {
    std::vector<double> breaks{0.0};
    for (const double end : {1.0, 1.5, potential.changes_from(), potential.cutoff().radius}) {
        if (end > breaks.back() && end <= potential.cutoff().radius) {
            breaks.push_back(end);
        }
    }
    return virial_integral([&](double r) { return potential(r).u; }, temperature, breaks);
}

double untruncated_second_virial_coefficient(const PairPotential& potential, double temperature) {
    return virial_integral([&](double r) { return potential.untruncated(r).u; }, temperature,
                           {0.0, 1.0, 1.5, 3.0, std::numeric_limits<double>::infinity()});
}

double boyle_temperature(const PairPotential& potential) {
    constexpr double coldest = 0.1;
    constexpr double hottest = 1000.0;
    return find_root([&](double t) { return untruncated_second_virial_coefficient(potential, t); }, coldest, hottest);
}

}  // namespace ljmd
