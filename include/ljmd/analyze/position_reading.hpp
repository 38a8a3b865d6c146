#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// How far atoms move from one frame of a trajectory to the next, along each axis, in edges of the box.
struct FrameMotion {
    double largest_step = 0.0;  ///< to the nearest periodic image
    Index jumps = 0;            ///< moves by more than half an edge, as the positions stand in the file
    double spread = 0.0;        ///< of all positions in the file
};

/// Measures it, frame after frame.
class FrameMotionMeter {
  public:
    /// @pre as many atoms in every frame
    void add(const Configuration& frame);

    /// The next frame does not go on from the last one: how far atoms have moved between them tells nothing.
    void begin_anew() { before_.clear(); }

    [[nodiscard]] const FrameMotion& motion() const { return motion_; }

  private:
    FrameMotion motion_;
    Vec3 lowest_ = Vec3::Zero();  ///< of all positions, in edges
    Vec3 highest_ = Vec3::Zero();
    bool has_frames_ = false;
    std::vector<Vec3> before_;  ///< positions in the last frame; none: that does not count
};

enum class Positions {
    wrapped,    ///< an atom that leaves the box comes in again on the other side
    unwrapped,  ///< its position goes on, or it leaves the box in no frame
};

/// How the positions of a trajectory are taken where displacements through the walls matter.
struct PositionReading {
    std::optional<Positions> positions;  ///< nothing: neither the file nor the displacements tell
    std::string told_by;                 ///< "file", "displacements" or "--positions"; empty where nothing tells
    std::string reason;                  ///< why nothing tells, and what to do
    std::string doubt;                   ///< what speaks against this reading; empty: nothing
};

/// Whether positions are wrapped. A wrapped position jumps by about an edge where its atom leaves the box; no atom of a
/// fluid moves like that from one frame to the next. So
///
/// - where no atom moves by more than half an edge the positions can be taken as they stand;
/// - where every move is less than a quarter of an edge, or that close to whole edges, with none in between, and all
///   positions lie in about one box, they are wrapped, and nearest images lead from frame to frame;
/// - else the file has to tell that they are unwrapped, or `said`, which counts more than anything else.
///
/// Positions whose nearest images are up to nearly half an edge away cannot be followed: nothing tells which image is
/// the right one.
///
/// @param file_tells_unwrapped  in every frame
/// @param said                  by the user
[[nodiscard]] PositionReading read_positions(const FrameMotion& motion, bool file_tells_unwrapped,
                                             std::optional<Positions> said);

/// For people: what was assumed, in one line.
[[nodiscard]] std::string description(const PositionReading& reading, const FrameMotion& motion);

}  // namespace ljmd
