#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/detail/options/units.hpp"

namespace ljmd {

/// Columns of the thermodynamic history of a fluid, one row per sample, in a file (ThermoCsv) or in memory.
///
/// In reduced units: step, time, temperature, potential_energy, kinetic_energy, total_energy (per atom), pressure,
/// pressure_xx, pressure_yy, pressure_zz, pressure_xy, pressure_xz, pressure_yz; then those chosen in `Extra`; then,
/// for a substance, time_ps, temperature_K, potential_energy_kJ_per_mol, kinetic_energy_kJ_per_mol,
/// total_energy_kJ_per_mol, pressure_bar. An undefined quantity is NaN.
class ThermoColumns {
  public:
    /// Columns that only some runs have.
    struct Extra {
        bool density = false;           ///< when a barostat changes it
        bool edges = false;             ///< edge_x, edge_y, edge_z, when a barostat changes each by itself
        bool external_energy = false;   ///< when an external force has an energy
        bool conserved_energy = false;  ///< when a thermostat has a conserved energy
        bool order_parameter = false;   ///< when the run started from a lattice
    };

    /// Values of those columns that are not part of a sample.
    struct Values {
        std::optional<double> conserved_energy;  ///< per atom [epsilon]
        std::optional<double> order_parameter;
    };

    ThermoColumns(const Extra& extra, std::optional<SubstanceUnits> units) : extra_(extra), units_(units) {}

    [[nodiscard]] std::vector<std::string> names() const;

    /// @return one number a column
    [[nodiscard]] std::vector<double> row(Index step, double time, const Thermodynamics& sample,
                                          const Values& values) const;

  private:
    Extra extra_;
    std::optional<SubstanceUnits> units_;
};

}  // namespace ljmd
