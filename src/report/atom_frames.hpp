#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/formats/trajectory_reader.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// Most bytes that the atoms may take on a page of so many atoms: 0.6 MB for small systems, at most 10.6 MB, so that a
/// page of 864 atoms stays below 2 MB and one of 32000 below 12 MB.
[[nodiscard]] double atom_bytes(Index atoms);

/// Collects the frames of a trajectory that a page shows, at even distances, in bounded memory: positions as 16-bit
/// fractions of the box, speeds, and numbers of neighbours within 1.5 sigma where there is room for them.
///
/// Frames 0, n, 2 n, ... are kept. Whenever more are kept than there is room for, every other one goes and n doubles.
class AtomFrames {
  public:
    /// @param expected  frames that are likely to come: n is chosen so that they just fit
    explicit AtomFrames(Index expected) : expected_(expected) {}

    /// @pre all frames have as many atoms as the first
    void add(const Frame& frame);

    [[nodiscard]] Index frames() const { return seen_; }

    /// The member `atoms` of the page's data; null without frames. src/report/web/README.md has its members.
    /// @param words  beside what was left out
    [[nodiscard]] Data data(const std::string& words) const;

  private:
    struct Kept {
        Index step;
        double time;
        Vec3 edges;
        std::vector<std::uint16_t> positions;
        std::vector<float> speeds;             ///< empty if the frame has no velocities
        std::vector<std::uint8_t> neighbours;  ///< empty if there is no room for them
    };

    void begin(const Frame& frame);
    [[nodiscard]] Kept kept(const Configuration& configuration) const;

    Index expected_;
    Index seen_ = 0;
    Index every_ = 1;
    Index room_ = 1;       ///< frames that may be kept
    Index atoms_ = 0;      ///< in the trajectory
    Index each_ = 1;       ///< every which atom is shown
    bool counts_ = false;  ///< whether neighbours are counted
    std::vector<Kept> kept_;
};

/// The atoms of a trajectory file; null if it has no frame. What cannot be read ends the frames, and `warnings` says
/// so. @param units  of the substance, for files in SI units
[[nodiscard]] Data trajectory_atoms(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                                    Index expected, std::vector<std::string>& warnings);

/// Neighbours of each atom within a distance, at most 255. At most 2048 atoms are looked at for each: where there are
/// more than 9 in sigma^3, the number may be too small. @pre the edges are above 0
[[nodiscard]] std::vector<std::uint8_t> neighbour_counts(const std::vector<Vec3>& positions, const Vec3& edges,
                                                         double distance);

}  // namespace ljmd
