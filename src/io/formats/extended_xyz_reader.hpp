#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/files/text_file.hpp"
#include "io/formats/one_kind.hpp"
#include "io/formats/trajectory_reader.hpp"
#include "ljmd/detail/options/units.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// What the first frame determines for all frames of a file.
struct ExtendedXyzPremises {
    std::optional<bool> si;  ///< empty before the first frame
    OneKind kind;
};

/// Read the last frame of an extended XYZ file:
///
///     N
///     comment line, see extended_xyz_header.hpp
///     one line per atom, columns as in Properties; unknown columns are skipped
///
/// Columns read: pos, velo (or vel, or velocities), id, mass (or masses), and those that distinguish kinds of atoms,
/// see one_kind.hpp: all atoms must be of one kind. Without velocities, ASE's momenta are read and divided by the mass
/// in the file, else by ASE's mass of the species; the quotient is in sqrt(eV/u) in a file in SI units, else in
/// sigma/tau. Without ids, atoms are in file order. Of a trajectory, forces (or force) are read, too: eV/angstrom in a
/// file in SI units. Every frame must be complete and well-formed; a file that is cut
/// off is an error. If the first frame says units=si (angstrom, angstrom/ps, ps, u), values are converted to reduced
/// units. A later frame with other units is refused.
///
/// @param file     at its start
/// @param units    of the substance; needed for SI files
/// @param comment  keys missing from the comment lines, see parse_extended_xyz_header()
/// @throws DataError with file, line and frame
[[nodiscard]] Configuration read_extended_xyz(TextFile& file, const std::optional<SubstanceUnits>& units,
                                              std::string_view comment = {});

/// The frames of such a file, one after the other. Positions are known to be unwrapped where a frame says
/// positions=unwrapped, as in files of ljmd. A last line without an end belongs to a frame that was cut off.
class ExtendedXyzTrajectory : public TrajectoryReader {
  public:
    /// @param units    of the substance; needed for SI files
    /// @param comment  keys missing from the comment lines
    ExtendedXyzTrajectory(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                          std::string comment = {})
        : file_(path), units_(units), comment_(std::move(comment)) {}

  private:
    bool read(Frame& frame) override;
    [[nodiscard]] bool is_cut() const override { return file_.is_cut(); }
    [[noreturn]] void fail(const std::string& message) const override { file_.fail(message); }

    TextFile file_;
    std::optional<SubstanceUnits> units_;
    ExtendedXyzPremises premises_;
    std::string comment_;
};

}  // namespace ljmd
