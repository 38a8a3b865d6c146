#include "io/tables/thermo_columns.hpp"

#include <array>
#include <limits>

namespace ljmd {

namespace {
double number(std::optional<double> value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}
}  // namespace

std::vector<std::string> ThermoColumns::names() const {
    std::vector<std::string> names{"step",         "time",        "temperature", "potential_energy", "kinetic_energy",
                                   "total_energy", "pressure",    "pressure_xx", "pressure_yy",      "pressure_zz",
                                   "pressure_xy",  "pressure_xz", "pressure_yz"};
    if (extra_.density) {
        names.emplace_back("density");
    }
    if (extra_.edges) {
        names.insert(names.end(), {"edge_x", "edge_y", "edge_z"});
    }
    if (extra_.external_energy) {
        names.emplace_back("external_energy");
    }
    if (extra_.conserved_energy) {
        names.emplace_back("conserved_energy");
    }
    if (extra_.order_parameter) {
        names.emplace_back("order_parameter");
    }
    if (units_) {
        names.insert(names.end(), {"time_ps", "temperature_K", "potential_energy_kJ_per_mol",
                                   "kinetic_energy_kJ_per_mol", "total_energy_kJ_per_mol", "pressure_bar"});
    }
    return names;
}

std::vector<double> ThermoColumns::row(Index step, double time, const Thermodynamics& sample,
                                       const Values& values) const {
    std::vector<double> row{static_cast<double>(step),  time,
                            number(sample.temperature), sample.potential_energy,
                            sample.kinetic_energy,      sample.total_energy,
                            number(sample.pressure)};
    constexpr std::array<std::array<int, 2>, 6> elements{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    for (const auto& [a, b] : elements) {
        row.push_back(number(sample.pressure_tensor ? std::optional((*sample.pressure_tensor)(a, b)) : std::nullopt));
    }
    if (extra_.density) {
        row.push_back(sample.density);
    }
    if (extra_.edges) {
        row.insert(row.end(), sample.edges.begin(), sample.edges.end());
    }
    if (extra_.external_energy) {
        row.push_back(number(sample.external_energy));
    }
    if (extra_.conserved_energy) {
        row.push_back(number(values.conserved_energy));
    }
    if (extra_.order_parameter) {
        row.push_back(number(values.order_parameter));
    }
    if (units_) {
        const double kilojoule = units_->kilojoule_per_mole();
        row.insert(row.end(), {time * units_->picosecond(), number(sample.temperature) * units_->kelvin(),
                               sample.potential_energy * kilojoule, sample.kinetic_energy * kilojoule,
                               sample.total_energy * kilojoule, number(sample.pressure) * units_->bar()});
    }
    return row;
}

}  // namespace ljmd
