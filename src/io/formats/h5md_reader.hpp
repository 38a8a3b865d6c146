#pragma once

#include "io/formats/atom_rows.hpp"
#include "io/formats/h5md_units.hpp"
#include "io/formats/one_kind.hpp"
#include "io/formats/trajectory_reader.hpp"
#include "io/hdf5/hdf5_input.hpp"

namespace ljmd {

/// The frames of an H5MD 1.1 file, written by any program:
///
///     particles/<group>           the one that is asked for, the only one, or `trajectory`
///       position                  value (F, N, 3); step, time
///       velocity, force, image    value (F, N, 3); may be missing, and are left out where they are at other steps than
///                                 the positions; forces also where their unit is not known
///       box                       boundary all periodic; edges (3) or (3, 3) fixed, or value (F, 3) or (F, 3, 3)
///       id                        (N) or value (F, N): atoms are sorted by it
///       species, mass             (N) or value (F, N), numbers or an enumeration: one kind of atom, see one_kind.hpp
///       charge                    the same; a remark where one is not 0 in the first frame
///     connectivity                a remark
///
/// `step` and `time` hold one entry per frame, or the increment between frames with an attribute `offset`; they may be
/// missing. Positions with an attribute `unit` are converted to reduced units, and so are times and velocities; all of
/// them have one or none has. Masses without a unit in a file with units are not used. An `image` is applied; ljmd's
/// own files hold unwrapped positions.
///
/// A file that was not closed after appending in SWMR mode, ljmd's mode, is read as far as it goes. If arrays have
/// different numbers of frames, the frames that all of them have are read.
/// Source: P. de Buyl et al. (2014), doi:10.1016/j.cpc.2014.01.018; nongnu.org/h5md
class H5mdReader : public TrajectoryReader {
  public:
    /// @param group  particle group; empty: the only one
    /// @throws DataError
    H5mdReader(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
               const std::string& group = {});

  private:
    /// An element, time-dependent or fixed.
    struct Element {
        std::string value;  ///< the dataset; empty: missing
        bool fixed = false;
    };

    bool read(Frame& frame) override;
    [[noreturn]] void fail(const std::string& message) const override;

    [[nodiscard]] std::string find_group(const std::string& wanted) const;
    [[nodiscard]] Element element(const std::string& name) const;
    [[nodiscard]] Element vectors(const std::string& name);
    void find_frames();
    [[nodiscard]] bool is_at_steps_of_positions(const std::string& name, const Element& element) const;
    void require_same_steps(const std::string& name) const;
    void check_box() const;
    void check_kind() const;
    void find_remarks();
    void require_of_atoms(const std::string& name, const Element& element) const;
    [[nodiscard]] std::vector<double> series(const std::string& array, Index entries) const;
    [[nodiscard]] Vec3 edges_of(Index frame) const;
    [[nodiscard]] AtomOrder order_of(Index frame) const;
    [[nodiscard]] std::vector<Vec3> vectors_of(const Element& element, Index frame, double unit) const;

    Hdf5Input file_;
    std::string group_;
    Element position_;
    Element velocity_;
    Element force_;
    Element image_;
    Element edges_;
    Element id_;
    std::optional<double> mass_;  ///< of every atom, in reduced units; nothing if unknown
    Index atom_count_ = 0;
    Index frame_count_ = 0;
    std::vector<double> steps_;  ///< of the frames; empty if the file has none
    std::vector<double> times_;
    H5mdScale scale_;
    double force_scale_ = 1.0;  ///< epsilon/sigma in the unit of the forces
    bool is_ljmd_ = false;
    std::vector<std::string> remarks_;  ///< on what acts on no atom of ljmd
};

}  // namespace ljmd
