#pragma once

#include <string>
#include <vector>

#include "judge/frame_judgement.hpp"
#include "judge/own_run.hpp"
#include "judge/point_judgement.hpp"
#include "judge/small_problem.hpp"

namespace ljmd::test {

inline constexpr double dt = 0.004;

/// The trajectory of an engine that does everything right: frames of ljmd's own.
inline JudgedTrajectory right_trajectory(const Fluid& fluid, const std::vector<Index>& steps) {
    JudgedTrajectory trajectory{fluid.edges, dt, {}};
    for (const Index step : steps) {
        trajectory.frames.push_back({.step = step, .positions = fluid.positions});
    }
    follow(fluid, *MadePeer::force_field_of(fluid), {}, trajectory);
    for (JudgedFrame& frame : trajectory.frames) {
        frame.positions = frame.our_positions;
        frame.velocities = frame.our_velocities;
        frame.forces = frame.our_forces;
    }
    return trajectory;
}

/// What is said, once ljmd's forces at the engine's positions are known.
inline std::vector<std::string> said(const Fluid& fluid, JudgedTrajectory trajectory) {
    follow(fluid, *MadePeer::force_field_of(fluid), {}, trajectory);
    return diagnose_trajectory(trajectory, fluid, *MadePeer::force_field_of(fluid), {}, engine_agreement({}));
}

inline std::vector<Vec3> moved(std::vector<Vec3> a, double factor, const std::vector<Vec3>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] += factor * b[i];
    }
    return a;
}

}  // namespace ljmd::test
