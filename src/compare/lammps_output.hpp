#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/files/text_file.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

// Readers for the output of the scripts of lammps_input.hpp. Unexpected output becomes a DataError with file and line.

/// A row of a table in the log: totals over all atoms.
struct LammpsRow {
    Index step;
    double potential_energy;  ///< U [epsilon]
    double kinetic_energy;    ///< K [epsilon]
    double virial_pressure;   ///< W/3V [epsilon/sigma^3]
};

/// The tables of a log, one after the other; other lines are skipped.
class LammpsLog {
  public:
    explicit LammpsLog(const std::filesystem::path& path) : file_(path) {}

    /// The next row; nothing after the last one. @throws DataError, also when the log ends within a table
    [[nodiscard]] std::optional<LammpsRow> next_row();

    /// "Loop time" of the last complete table [s]. @throws DataError when there is none
    [[nodiscard]] double loop_seconds() const;

  private:
    TextFile file_;
    std::vector<std::string_view> fields_;
    bool in_table_ = false;
    std::optional<double> seconds_;
};

/// Version information from `lmp -h`.
struct LammpsVersion {
    std::string version;  ///< "29 Sep 2021 - Update 2"
    bool openmp;          ///< has the package OPENMP: pair styles with threads
};
/// Nothing if the text is not from LAMMPS.
[[nodiscard]] std::optional<LammpsVersion> lammps_version(const std::string& help);

}  // namespace ljmd
