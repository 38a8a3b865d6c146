#include "reference/near_critical.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace ljmd {

namespace {

struct Node {
    double place;
    double weight;
};

/// Nodes above 0 and weights of Gauss and Legendre's rule of eight points on -1 to 1, exact up to t^15. Source: NIST
/// Digital Library of Mathematical Functions, table 3.5.2.
constexpr std::array<Node, 4> nodes{{{0.18343464249564980, 0.36268378337836198},
                                     {0.52553240991632899, 0.31370664587788729},
                                     {0.79666647741362674, 0.22238103445337447},
                                     {0.96028985649753623, 0.10122853629037626}}};

/// The two integrals, and their derivatives by the middle m and half the distance d.
struct Conditions {
    double pressure = 0.0;
    double pressure_by_middle = 0.0;
    double pressure_by_half = 0.0;
    double potential = 0.0;
    double potential_by_middle = 0.0;
    double potential_by_half = 0.0;
};

Conditions conditions(const EquationOfState& equation, double temperature, double middle, double half) {
    Conditions sum;
    for (const auto& [place, weight] : nodes) {
        for (const double t : {-place, place}) {
            const double density = middle + half * t;
            const FluidProperties there = properties(equation, temperature, density);
            const double slope = there.pressure_density_slope;
            const double curvature = there.pressure_density_curvature;
            sum.pressure += weight * slope;
            sum.pressure_by_middle += weight * curvature;
            sum.pressure_by_half += weight * curvature * t;
            const double by_density = (curvature - slope / density) / density;
            sum.potential += weight * slope * t / density;
            sum.potential_by_middle += weight * by_density * t;
            sum.potential_by_half += weight * by_density * t * t;
        }
    }
    return sum;
}

}  // namespace

std::optional<SaturatedDensities> saturated_near_critical(const EquationOfState& equation, double temperature,
                                                          const Spinodals& spinodals) {
    constexpr int most_steps = 30;
    constexpr double known = 0.01;
    double middle = 0.5 * (spinodals.liquid + spinodals.vapour);
    double half = 0.5 * std::sqrt(3.0) * (spinodals.liquid - spinodals.vapour);
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps && half > 0.0; ++step) {
        const Conditions c = conditions(equation, temperature, middle, half);
        const double determinant =
            c.pressure_by_middle * c.potential_by_half - c.pressure_by_half * c.potential_by_middle;
        const double move = (c.pressure_by_half * c.potential - c.potential_by_half * c.pressure) / determinant;
        const double stretch = (c.potential_by_middle * c.pressure - c.pressure_by_middle * c.potential) / determinant;
        middle += move;
        half += stretch;
        const double change = std::abs(stretch / half);
        if (change < known && change >= last) {  // rounding is all that is left
            return SaturatedDensities{middle - half, middle + half};
        }
        last = change;
    }
    return std::nullopt;
}

std::string critical_in_words(double given, double critical) {
    constexpr double look_the_same = 1e-5;
    return std::abs(given / critical - 1.0) < look_the_same ? fmt::format("{}", critical)
                                                            : fmt::format("{:.6g}", critical);
}

std::string too_near_critical(const std::string& quantity, double given, const std::string& equation, double critical) {
    return fmt::format(
        "{} {} is so near to the critical one of {}, {}, that rounding hides the difference between "
        "vapour and liquid: the critical point describes both",
        quantity, given, equation, critical_in_words(given, critical));
}

}  // namespace ljmd
