#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/io/files/text_file.hpp"

namespace ljmd {

// What the scripts of lammps_input.hpp make LAMMPS write, read one piece at a time. What is not as expected is a
// DataError with file and line.

/// A row of a table in the log, totals of all atoms.
struct LammpsRow {
    Index step;
    double potential_energy;  ///< U [epsilon]
    double kinetic_energy;    ///< K [epsilon]
    double virial_pressure;   ///< W/3V [epsilon/sigma^3]
};

/// The tables of a log, one after the other; what stands between them is passed over.
class LammpsLog {
  public:
    explicit LammpsLog(const std::filesystem::path& path) : file_(path) {}

    /// The next row; nothing when there is none. @throws DataError also when the log ends within a table
    [[nodiscard]] std::optional<LammpsRow> next_row();

    /// "Loop time" of the last table that was read to its end [s]. @throws DataError when there was none
    [[nodiscard]] double loop_seconds() const;

  private:
    TextFile file_;
    std::vector<std::string_view> fields_;
    bool in_table_ = false;
    std::optional<double> seconds_;
};

/// What `lmp -h` says of itself.
struct LammpsVersion {
    std::string version;  ///< "29 Sep 2021 - Update 2"
    bool openmp;          ///< it has the package OPENMP, of pair styles with threads
};
/// Nothing when the text is not that of LAMMPS.
[[nodiscard]] std::optional<LammpsVersion> lammps_version(const std::string& help);

}  // namespace ljmd
