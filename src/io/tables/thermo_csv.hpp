#pragma once

#include <cstdint>
#include <optional>

#include "io/files/output_file.hpp"
#include "io/tables/thermo_columns.hpp"

namespace ljmd {

/// The thermodynamic history of a run as CSV, one row per sample, with the columns of ThermoColumns. An undefined
/// quantity is an empty field.
class ThermoCsv {
  public:
    /// @param kept  bytes of a file to continue; none: a new file  @throws FileError, CheckpointError
    ThermoCsv(const OutputPlace& place, const ThermoColumns& columns, std::optional<std::int64_t> kept = std::nullopt);

    /// @throws FileError
    void write(Index step, double time, const Thermodynamics& sample, const ThermoColumns::Values& values);

    /// Hand what was written so far to the system: it survives a kill of the program.
    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// Synchronise what was written so far: it survives a power cut. @return length of the file in bytes
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    ThermoColumns columns_;
};

}  // namespace ljmd
