#include "report/reference_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/equation_doubts.hpp"

namespace ljmd {

std::optional<BeyondCutoff> beyond_cutoff(const DataTable& rdf, double cutoff, double density) {
    const auto place = [&](const char* name) { return std::ranges::find(rdf.columns, name) - rdf.columns.begin(); };
    const auto at_r = static_cast<std::size_t>(place("r"));
    const auto at_g = static_cast<std::size_t>(place("g"));
    if (std::max(at_r, at_g) >= rdf.columns.size() || rdf.rows.size() < 2 || !(rdf.rows.back()[at_r] >= cutoff + 1.0)) {
        return std::nullopt;
    }
    const double width = rdf.rows[1][at_r] - rdf.rows[0][at_r];
    BeyondCutoff sum{0.0, 0.0};
    for (const auto& row : rdf.rows) {
        const double r = row[at_r];
        if (r <= cutoff) {
            continue;
        }
        const double pairs = 2.0 * std::numbers::pi * density * (row[at_g] - 1.0) * r * r * width;
        const double inverse = std::pow(r, -6);
        sum.energy += pairs * 4.0 * inverse * (inverse - 1.0);
        sum.pressure += pairs * density / 3.0 * 24.0 * inverse * (2.0 * inverse - 1.0);  // -r phi'
    }
    return std::isfinite(sum.energy) ? std::optional(sum) : std::nullopt;
}

double difference_of_equations(const EquationOfState& equation, double temperature, double density,
                               double FluidProperties::*property) {
    if (!equation.full_potential) {
        return 0.0;  // others are of other truncations
    }
    const double here = properties(equation, temperature, density).*property;
    double largest = 0.0;
    for (const EquationOfState& other : all_equations_of_state()) {
        if (other.full_potential && doubts(other, temperature, density).empty()) {
            largest = std::max(largest, std::abs(properties(other, temperature, density).*property - here));
        }
    }
    return largest;
}

}  // namespace ljmd
