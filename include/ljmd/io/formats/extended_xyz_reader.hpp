#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ljmd/core/units.hpp"
#include "ljmd/io/files/text_file.hpp"
#include "ljmd/io/formats/one_kind.hpp"
#include "ljmd/io/formats/trajectory_reader.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// What the first frame of a file says for all of them.
struct ExtendedXyzPremises {
    std::optional<bool> si;  ///< empty before the first frame
    OneKind kind;
};

/// Read the last frame of an extended XYZ file:
///
///     N
///     comment line, see extended_xyz_header.hpp
///     one line an atom, columns as Properties says; unknown columns are skipped
///
/// Read are the columns pos, velo (or vel, or velocities), id and mass (or masses), and those that tell kinds of atoms
/// apart, see one_kind.hpp: all atoms must be of one kind. Without velocities, momenta as ASE writes them are read,
/// over the mass that the file gives or ASE takes for the species: in sqrt(eV/u) where the file is in SI units, else
/// sigma/tau. Without ids, the order in the file counts. Every frame must be complete and well-formed, the last one
/// most of all: a cut is an error. A file whose first frame says units=si (angstrom, angstrom/ps, ps, u) is converted
/// to reduced units; a later frame that says otherwise is refused.
///
/// @param file     at its start
/// @param units    of the substance; needed for SI files
/// @param comment  what the comment lines lack, see parse_extended_xyz_header()
/// @throws DataError with file, line and frame
[[nodiscard]] Configuration read_extended_xyz(TextFile& file, const std::optional<SubstanceUnits>& units,
                                              std::string_view comment = {});

/// All frames of such a file, one after the other. Those that say positions=unwrapped, as ljmd's do, have unwrapped
/// positions; of others that is not told. A last line without its end belongs to a frame that was cut off.
class ExtendedXyzTrajectory : public TrajectoryReader {
  public:
    /// @param units    of the substance; needed for SI files
    /// @param comment  what the comment lines lack
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
