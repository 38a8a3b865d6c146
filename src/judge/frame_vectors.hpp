#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/frame_judgement.hpp"

namespace ljmd {

/// A mistake of a trajectory is found if it explains all of a difference but this part.
inline constexpr double unexplained_of_frames = 1e-2;

inline double root_of_squares(const std::vector<Vec3>& vectors) {
    double sum = 0.0;
    for (const Vec3& v : vectors) {
        sum += v.squaredNorm();
    }
    return std::sqrt(sum);
}

/// a + c b - d, summed in squares.
inline double distance(const std::vector<Vec3>& a, double c, const std::vector<Vec3>& b, const std::vector<Vec3>& d) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] + c * b[i] - d[i]).squaredNorm();
    }
    return std::sqrt(sum);
}

/// The frame of a step; null if there is none.
inline const JudgedFrame* frame_of(const JudgedTrajectory& trajectory, Index step) {
    const auto found = std::ranges::find(trajectory.frames, step, &JudgedFrame::step);
    return found == trajectory.frames.end() ? nullptr : &*found;
}

/// Positions of an engine as those images that are nearest to ours.
inline std::vector<Vec3> nearest_to_ours(const JudgedFrame& frame, const Vec3& edges) {
    std::vector<Vec3> places;
    places.reserve(frame.positions.size());
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Vec3 apart = frame.positions[i] - frame.our_positions[i];
        const Vec3 images = (apart.array() / edges.array()).round();
        places.emplace_back(frame.positions[i] - images.cwiseProduct(edges));
    }
    return places;
}

}  // namespace ljmd
