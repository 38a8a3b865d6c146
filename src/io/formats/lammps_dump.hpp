#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/text_file.hpp"
#include "io/formats/atom_rows.hpp"
#include "io/formats/one_kind.hpp"
#include "io/formats/trajectory_reader.hpp"

namespace ljmd {

/// The frames of a LAMMPS text dump, one after the other:
///
///     ITEM: UNITS, ITEM: TIME             optional; units must be lj
///     ITEM: TIMESTEP
///     ITEM: NUMBER OF ATOMS
///     ITEM: BOX BOUNDS pp pp pp           an orthogonal, periodic box; xy xz yz before pp: tilt factors, of zero;
///                                         abc origin before pp: three vectors along the axes, and a corner
///     ITEM: ATOMS id ...                  columns in any order, atoms in any order; ids may have gaps
///
/// Dumps of LAMMPS before 2010 do not name the boundaries; these are taken as periodic.
/// Source: LAMMPS documentation, dump and dump_modify commands
class LammpsDump {
  public:
    explicit LammpsDump(const std::filesystem::path& path) : file_(path) {}

    /// Go to the next frame and read its header.
    /// @param atoms  required number of atoms; 0: any
    /// @return false at the end of the file  @throws DataError
    bool next_frame(Index atoms = 0);

    [[nodiscard]] Index step() const { return step_; }
    [[nodiscard]] Index atoms() const { return atoms_; }
    [[nodiscard]] std::optional<double> time() const { return time_; }
    [[nodiscard]] const Vec3& low() const { return low_; }      ///< corner of the box
    [[nodiscard]] const Vec3& edges() const { return edges_; }  ///< of the box
    [[nodiscard]] Index box_line() const { return box_line_; }
    [[nodiscard]] bool tells_boundaries() const { return tells_boundaries_; }

    [[nodiscard]] bool has(std::string_view column) const;

    /// Per-atom numbers: one row per atom in the order of ids, one column per name.
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// Read the atoms of the frame; may be called once per frame. More than one kind of atom is refused.
    /// Forces that are no numbers are NaN. @throws DataError, also for a missing column
    [[nodiscard]] Rows read_atoms(const std::vector<std::string>& columns);

    /// On columns that act on no atom of ljmd, in the atoms read last.
    [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

    /// In which line each atom was.
    [[nodiscard]] const AtomOrder& order() const { return order_; }

    [[nodiscard]] TextFile& file() { return file_; }
    [[nodiscard]] const TextFile& file() const { return file_; }

  private:
    void require_line(std::string_view what);
    void read_item(std::string_view item, Index atoms);
    void read_bounds(std::string_view boundaries);
    void read_vectors(const std::vector<std::string_view>& boundaries, std::string_view line);
    void check_boundaries(const std::vector<std::string_view>& names, std::string_view line);
    void read_columns(std::string_view names);
    [[nodiscard]] std::size_t column(std::string_view name) const;

    TextFile file_;
    Index frames_ = 0;
    Index step_ = -1;
    Index atoms_ = 0;
    std::optional<double> time_;
    Vec3 low_ = Vec3::Zero();
    Vec3 edges_ = Vec3::Zero();
    Index box_line_ = 0;
    bool tells_boundaries_ = true;
    std::vector<std::string> columns_;
    AtomOrder order_;
    OneKind kind_;
    std::vector<std::string> remarks_;
};

/// A dump as a trajectory. Positions are xu yu zu or xsu ysu zsu, else x y z or xs ys zs, unwrapped if there are ix iy
/// iz. Velocities are vx vy vz, forces fx fy fz, masses are in `mass`. Positions are shifted by -(xlo, ylo, zlo).
class LammpsDumpTrajectory : public TrajectoryReader {
  public:
    explicit LammpsDumpTrajectory(const std::filesystem::path& path) : dump_(path) {}

  private:
    bool read(Frame& frame) override;
    [[nodiscard]] bool is_cut() const override { return dump_.file().is_cut(); }
    [[noreturn]] void fail(const std::string& message) const override { dump_.file().fail(message); }

    LammpsDump dump_;
};

}  // namespace ljmd
