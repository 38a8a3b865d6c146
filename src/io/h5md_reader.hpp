#pragma once

#include "h5md_units.hpp"
#include "hdf5_input.hpp"
#include "ljmd/io/trajectory_reader.hpp"

namespace ljmd {

/// The frames of an H5MD 1.1 file, by whatever program:
///
///     particles/<group>           the one group there is, or `trajectory`
///       position                  value (F, N, 3); step, time
///       velocity, image           value (F, N, 3), at the steps of the positions; may be missing
///       box                       boundary all periodic; edges (3) or (3, 3) fixed, or value (F, 3) or (F, 3, 3)
///       id                        (N) or value (F, N): atoms are sorted by it
///       species                   (N): one kind of atom
///
/// `step` and `time` hold one entry a frame, or the increment from one to the next with an attribute `offset`; they may
/// be missing. Positions with an attribute `unit` are converted to reduced units, and so are times and velocities; all
/// have one or none has. Where there is an `image`, it is applied; ljmd's own files hold unwrapped positions.
///
/// A file that was not closed after appending in SWMR mode, as ljmd writes, is read as far as it goes. Where arrays
/// have different numbers of frames, those are read that all of them have.
/// Source: P. de Buyl et al. (2014), doi:10.1016/j.cpc.2014.01.018; nongnu.org/h5md
class H5mdReader : public TrajectoryReader {
  public:
    H5mdReader(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units);

  private:
    /// A time-dependent element, or one that never changes.
    struct Element {
        std::string value;  ///< the dataset; empty: there is none
        bool fixed = false;
    };

    bool read(Frame& frame) override;
    [[noreturn]] void fail(const std::string& message) const override;

    [[nodiscard]] std::string find_group() const;
    [[nodiscard]] Element element(const std::string& name) const;
    [[nodiscard]] Element vectors(const std::string& name);
    void find_frames();
    void require_same_steps(const std::string& name) const;
    void check_box() const;
    void check_species() const;
    [[nodiscard]] std::vector<double> series(const std::string& array) const;
    [[nodiscard]] Vec3 edges_of(Index frame) const;
    [[nodiscard]] std::vector<Index> order_of(Index frame) const;
    [[nodiscard]] std::vector<Vec3> vectors_of(const Element& element, Index frame, double unit) const;

    Hdf5Input file_;
    std::string group_;
    Element position_;
    Element velocity_;
    Element image_;
    Element edges_;
    Element id_;
    Index atom_count_ = 0;
    Index frame_count_ = 0;
    std::vector<double> steps_;  ///< of the frames; empty where the file has none
    std::vector<double> times_;
    H5mdScale scale_;
    bool is_ljmd_ = false;
};

}  // namespace ljmd
