#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/io/text_file.hpp"

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

/// The frames of a dump with the id and one vector for each atom, sorted by id.
class LammpsDump {
  public:
    /// @param columns  "id xu yu zu"
    LammpsDump(const std::filesystem::path& path, Index atoms, std::string columns)
        : file_(path), atoms_(atoms), columns_(std::move(columns)) {}

    /// Go to the next frame. @throws DataError also when there is none
    void next_frame();

    [[nodiscard]] Index step() const { return step_; }
    [[nodiscard]] const std::vector<Vec3>& vectors() const { return vectors_; }

  private:
    void next_line();
    void expect(std::string_view line);

    TextFile file_;
    Index atoms_;
    std::string columns_;
    Index step_ = -1;
    std::vector<Vec3> vectors_;
    std::vector<std::string_view> fields_;
};

/// What `lmp -h` says of itself.
struct LammpsVersion {
    std::string version;  ///< "29 Sep 2021 - Update 2"
    bool openmp;          ///< it has the package OPENMP, of pair styles with threads
};
/// Nothing when the text is not that of LAMMPS.
[[nodiscard]] std::optional<LammpsVersion> lammps_version(const std::string& help);

}  // namespace ljmd
