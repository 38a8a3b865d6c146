#pragma once

#include <filesystem>
#include <optional>

#include "ljmd/core/units.hpp"
#include "ljmd/io/files/output_file.hpp"
#include "ljmd/observables/thermodynamics.hpp"

namespace ljmd {

/// The thermodynamic history of a run as CSV, one row per sample.
///
/// Columns in reduced units: step, time, temperature, potential_energy, kinetic_energy, total_energy (per atom),
/// pressure, pressure_xx, pressure_yy, pressure_zz, pressure_xy, pressure_xz, pressure_yz; then those chosen in
/// `Extra`; then, for a substance, time_ps, temperature_K, potential_energy_kJ_per_mol, kinetic_energy_kJ_per_mol,
/// total_energy_kJ_per_mol, pressure_bar. An undefined quantity is an empty field.
class ThermoCsv {
  public:
    /// Columns that only some runs have.
    struct Extra {
        bool density = false;           ///< when a barostat changes it
        bool conserved_energy = false;  ///< when a thermostat has a conserved energy
        bool order_parameter = false;   ///< when the run started from a lattice
    };

    /// Values of these columns, except the density.
    struct Values {
        std::optional<double> conserved_energy;  ///< per atom [epsilon]
        std::optional<double> order_parameter;
    };

    /// @param kept  bytes of a file to continue; none: a new file  @throws FileError, CheckpointError
    ThermoCsv(const OutputPlace& place, const Extra& extra, std::optional<SubstanceUnits> units,
              std::optional<std::int64_t> kept = std::nullopt);

    /// @throws FileError
    void write(Index step, double time, const Thermodynamics& row, const Values& values);

    /// Hand what was written so far to the system: it survives a kill of the program.
    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// Synchronise what was written so far: it survives a power cut. @return length of the file in bytes
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    Extra extra_;
    std::optional<SubstanceUnits> units_;
};

}  // namespace ljmd
