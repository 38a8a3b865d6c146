#include "ljmd/io/tables/thermo_csv.hpp"

#include <fmt/format.h>

#include <array>

namespace ljmd {

namespace {
std::string field(std::optional<double> value) {
    return value ? fmt::format("{}", *value) : std::string();
}
}  // namespace

ThermoCsv::ThermoCsv(const OutputPlace& place, const Extra& extra, std::optional<SubstanceUnits> units,
                     std::optional<std::int64_t> kept)
    : file_(place, kept), extra_(extra), units_(units) {
    if (kept) {
        return;
    }
    file_.write(
        "step,time,temperature,potential_energy,kinetic_energy,total_energy,pressure,"
        "pressure_xx,pressure_yy,pressure_zz,pressure_xy,pressure_xz,pressure_yz");
    if (extra_.density) {
        file_.write(",density");
    }
    if (extra_.conserved_energy) {
        file_.write(",conserved_energy");
    }
    if (extra_.order_parameter) {
        file_.write(",order_parameter");
    }
    if (units_) {
        file_.write(
            ",time_ps,temperature_K,potential_energy_kJ_per_mol,kinetic_energy_kJ_per_mol,total_energy_kJ_per_mol,"
            "pressure_bar");
    }
    file_.write("\n");
}

void ThermoCsv::write(Index step, double time, const Thermodynamics& row, const Values& values) {
    std::string line = fmt::format("{},{},{},{},{},{},{}", step, time, field(row.temperature), row.potential_energy,
                                   row.kinetic_energy, row.total_energy, field(row.pressure));
    constexpr std::array<std::array<int, 2>, 6> elements{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    for (const auto& [a, b] : elements) {
        line += ',' + field(row.pressure_tensor ? std::optional((*row.pressure_tensor)(a, b)) : std::nullopt);
    }
    if (extra_.density) {
        line += ',' + field(row.density);
    }
    if (extra_.conserved_energy) {
        line += ',' + field(values.conserved_energy);
    }
    if (extra_.order_parameter) {
        line += ',' + field(values.order_parameter);
    }
    if (units_) {
        const auto kelvin = row.temperature ? std::optional(*row.temperature * units_->kelvin()) : std::nullopt;
        const auto bar = row.pressure ? std::optional(*row.pressure * units_->bar()) : std::nullopt;
        const double kilojoule = units_->kilojoule_per_mole();
        line += fmt::format(",{},{},{},{},{},{}", time * units_->picosecond(), field(kelvin),
                            row.potential_energy * kilojoule, row.kinetic_energy * kilojoule,
                            row.total_energy * kilojoule, field(bar));
    }
    file_.write(line + '\n');
}

}  // namespace ljmd
