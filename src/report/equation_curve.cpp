#include "report/equation_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "reference/equation_doubts.hpp"
#include "report/run_quantities.hpp"

namespace ljmd {

namespace {

constexpr int most_places = 120;  // of all curves together

/// Give the points of a curve one temperature where theirs agree within three errors.
void join_temperatures(std::vector<StateOnAxis>& curve) {
    double weights = 0.0;
    double mean = 0.0;
    for (const StateOnAxis& state : curve) {
        const double weight = 1.0 / (state.temperature_error * state.temperature_error);
        weights += weight;
        mean += weight * (state.temperature - curve.front().temperature);
    }
    mean = curve.front().temperature + mean / weights;
    const auto agrees = [mean](const StateOnAxis& state) {
        return std::abs(state.temperature - mean) <= 3.0 * state.temperature_error;
    };
    if (std::ranges::all_of(curve, agrees)) {  // not where an error is unknown or zero: the mean is NaN
        for (StateOnAxis& state : curve) {
            state.temperature = mean;
        }
    }
}

}  // namespace

PageTable equation_curves(const std::string& x, const std::vector<StateOnAxis>& states) {
    std::map<std::string, std::vector<StateOnAxis>> curves;
    for (const StateOnAxis& state : states) {
        if (!state.equation.empty() && std::isfinite(state.place + state.temperature + state.density)) {
            curves[state.series].push_back(state);
        }
    }
    std::vector<double> places;
    std::vector<std::string> series;
    std::vector<std::vector<double>> values(comparable_properties().size());
    const int parts = std::max(1, most_places / std::max(static_cast<int>(states.size()), 1));
    for (auto& [name, curve] : curves) {
        if (x != "temperature") {
            join_temperatures(curve);
        }
        for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
            const StateOnAxis& from = curve[k];
            const StateOnAxis& to = curve[k + 1];
            if (from.equation != to.equation) {
                continue;
            }
            const EquationOfState equation = equation_of_state(from.equation);
            for (int part = k == 0 ? 0 : 1; part <= parts; ++part) {
                const double share = static_cast<double>(part) / parts;
                const double temperature = std::lerp(from.temperature, to.temperature, share);
                const double density = std::lerp(from.density, to.density, share);
                const bool holds = doubts(equation, temperature, density).empty();
                places.push_back(std::lerp(from.place, to.place, share));
                series.push_back(name);
                for (std::size_t column = 0; column < values.size(); ++column) {
                    values[column].push_back(holds ? properties(equation, temperature, density).*
                                                         comparable_properties()[column].property
                                                   : std::numeric_limits<double>::quiet_NaN());
                }
            }
        }
    }
    PageTable table{.name = "equation", .title = "Equation of state"};
    if (places.empty()) {
        return table;
    }
    table.add({x}, places);
    table.add({"series"}, series);
    for (std::size_t column = 0; column < values.size(); ++column) {
        table.add({std::string(comparable_properties()[column].name) + "_reference"}, values[column]);
    }
    return table;
}

}  // namespace ljmd
