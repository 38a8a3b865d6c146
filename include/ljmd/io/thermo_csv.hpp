#pragma once

#include <filesystem>
#include <optional>

#include "ljmd/core/units.hpp"
#include "ljmd/io/output_file.hpp"
#include "ljmd/observables/thermodynamics.hpp"

namespace ljmd {

/// The thermodynamic history of a run, one row a sample, as CSV.
///
/// Columns in reduced units: step, time, temperature, potential_energy, kinetic_energy, total_energy (per atom),
/// pressure, pressure_xx, pressure_yy, pressure_zz, pressure_xy, pressure_xz, pressure_yz; order_parameter when the run
/// started from a lattice; then, for a substance, time_ps, temperature_K, potential_energy_kJ_per_mol,
/// kinetic_energy_kJ_per_mol, total_energy_kJ_per_mol, pressure_bar. A quantity that is not defined is an empty field.
class ThermoCsv {
  public:
    /// @param kept  bytes of a file to go on with; none: a new one  @throws FileError, CheckpointError
    ThermoCsv(const std::filesystem::path& path, bool order_parameter, std::optional<SubstanceUnits> units,
              std::optional<std::int64_t> kept = std::nullopt);

    /// @throws FileError
    void write(Index step, double time, const Thermodynamics& row, std::optional<double> order_parameter);

    /// What was written so far survives a kill of the program.
    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// What was written so far survives a power cut. @return bytes of it
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    bool order_parameter_;
    std::optional<SubstanceUnits> units_;
};

}  // namespace ljmd
