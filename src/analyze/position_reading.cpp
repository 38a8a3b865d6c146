#include "analyze/position_reading.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ljmd {

namespace {

// In units of the box edges.
constexpr double short_step = 0.25;       ///< up to here atoms can be followed without doubt
constexpr double followable_step = 0.45;  ///< beyond it, two images are almost equally near
constexpr double wrapped_spread = 1.5;    ///< programs that wrap only now and then leave atoms outside for a while

bool jumps_by_edges(const FrameMotion& motion) {
    return motion.jumps > 0 && motion.largest_step < short_step && motion.spread < wrapped_spread;
}

std::string moves(const FrameMotion& motion) {
    return fmt::format(
        "from frame to frame atoms move by up to {:.2g} edges of the box to their nearest images, and {} "
        "{} by more than half an edge as the positions stand",
        motion.largest_step, motion.jumps, motion.jumps == 1 ? "time" : "times");
}

PositionReading as_said(const FrameMotion& motion, Positions said) {
    PositionReading reading{said, "--positions", "", ""};
    if (said == Positions::unwrapped && jumps_by_edges(motion)) {
        reading.doubt = fmt::format("--positions unwrapped, but the positions look wrapped: {}", moves(motion));
    } else if (said == Positions::wrapped && motion.largest_step > followable_step) {
        reading.positions.reset();
        reading.reason = fmt::format(
            "--positions wrapped: {}, which is too far to follow them: use frames closer in time", moves(motion));
    } else if (said == Positions::wrapped && motion.largest_step >= short_step) {
        reading.doubt = fmt::format(
            "--positions wrapped: {}; where one has moved by more than half an edge, its nearest "
            "image is the wrong one",
            moves(motion));
    }
    return reading;
}

}  // namespace

void FrameMotionMeter::add(const Configuration& frame) {
    if (!has_frames_ && !frame.positions.empty()) {
        has_frames_ = true;
        lowest_ = highest_ = frame.positions[0].cwiseQuotient(frame.edges);
    }
    for (std::size_t k = 0; k < frame.positions.size(); ++k) {
        const Vec3 place = frame.positions[k].cwiseQuotient(frame.edges);
        lowest_ = lowest_.cwiseMin(place);
        highest_ = highest_.cwiseMax(place);
        if (before_.empty()) {
            continue;
        }
        const Vec3 moved = (frame.positions[k] - before_[k]).cwiseQuotient(frame.edges);
        const Vec3 whole = moved.array().round();
        motion_.largest_step = std::max(motion_.largest_step, (moved - whole).cwiseAbs().maxCoeff());
        motion_.jumps += (whole.array() != 0.0).count();
    }
    motion_.spread = (highest_ - lowest_).maxCoeff();
    before_ = frame.positions;
}

PositionReading read_positions(const FrameMotion& motion, bool file_tells_unwrapped, std::optional<Positions> said) {
    if (said) {
        return as_said(motion, *said);
    }
    if (jumps_by_edges(motion)) {
        return {Positions::wrapped, "displacements", "",
                file_tells_unwrapped
                    ? fmt::format("the file says that positions are unwrapped, but they are wrapped: {}", moves(motion))
                    : ""};
    }
    if (file_tells_unwrapped) {
        return {Positions::unwrapped, "file", "", ""};
    }
    if (motion.jumps == 0) {
        return {Positions::unwrapped, "displacements", "", ""};
    }
    return {std::nullopt, "",
            fmt::format("neither the file nor the displacements tell whether positions are wrapped: {}. --positions "
                        "wrapped follows atoms by their nearest images, --positions unwrapped takes the positions as "
                        "they stand",
                        moves(motion)),
            ""};
}

std::string description(const PositionReading& reading, const FrameMotion& motion) {
    if (!reading.positions) {
        return reading.reason;
    }
    const std::string how =
        *reading.positions == Positions::wrapped
            ? fmt::format("wrapped, atoms followed by their nearest images, at most {:.2g} edges away",
                          motion.largest_step)
            : "unwrapped";
    return fmt::format("positions: {} ({})", how,
                       reading.told_by == "displacements" && motion.jumps == 0
                           ? "no atom moves by more than half an edge between frames"
                           : fmt::format("told by {}", reading.told_by == "file" ? "the file" : reading.told_by));
}

}  // namespace ljmd
