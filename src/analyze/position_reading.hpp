#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Motion of the atoms between neighbouring frames of a trajectory, per axis, in edges of the box.
struct FrameMotion {
    double largest_step = 0.0;  ///< largest move to the nearest periodic image
    Index jumps = 0;            ///< moves of more than half an edge, with positions as in the file
    double spread = 0.0;        ///< extent of all positions in the file
};

/// Measures the motion frame by frame.
class FrameMotionMeter {
  public:
    /// @pre every frame has the same number of atoms
    void add(const Configuration& frame);

    /// Call it if the next frame does not continue the last one: the motion between them is then not measured.
    void begin_anew() { before_.clear(); }

    [[nodiscard]] const FrameMotion& motion() const { return motion_; }

  private:
    FrameMotion motion_;
    Vec3 lowest_ = Vec3::Zero();  ///< of all positions, in edges
    Vec3 highest_ = Vec3::Zero();
    bool has_frames_ = false;
    std::vector<Vec3> before_;  ///< positions in the last frame; empty if the next frame does not continue it
};

enum class Positions {
    wrapped,    ///< an atom that leaves the box re-enters on the opposite side
    unwrapped,  ///< positions continue outside the box, or no atom leaves it
};

/// How to treat the positions of a trajectory where displacements across the walls matter.
struct PositionReading {
    std::optional<Positions> positions;  ///< nothing: neither the file nor the displacements show it
    std::string told_by;                 ///< "file", "displacements" or "--positions"; empty if unknown
    std::string reason;                  ///< why it is unknown, and what to do
    std::string doubt;                   ///< evidence against this reading; empty if there is none
};

/// Determine whether positions are wrapped. A wrapped position jumps by about an edge when its atom leaves the box; no
/// atom of a fluid moves that far between frames. So
///
/// - if no atom moves by more than half an edge, positions can be used as they are;
/// - if every move is less than a quarter of an edge from zero or from a whole number of edges, some are by whole
///   edges, and all positions are in about one box, positions are wrapped, and nearest images connect the frames;
/// - otherwise the file must say that they are unwrapped. `said` takes precedence over everything else.
///
/// Wrapped positions cannot be followed when nearest images are almost half an edge away: the correct image is then
/// unknown.
///
/// @param file_tells_unwrapped  every frame says so
/// @param said                  the user's choice
[[nodiscard]] PositionReading read_positions(const FrameMotion& motion, bool file_tells_unwrapped,
                                             std::optional<Positions> said);

/// One line for the user about the reading.
[[nodiscard]] std::string description(const PositionReading& reading, const FrameMotion& motion);

}  // namespace ljmd
