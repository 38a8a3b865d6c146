#include "judge/method_diagnosis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "judge/frame_vectors.hpp"
#include "judge/own_run.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr Index last_step_of_a_method = 100;  // that is worth following for each method
constexpr std::size_t frames_of_a_method = 3;

/// How a step goes, see wrong_method().
struct Method {
    double a_in_r;
    double a_in_v;
    double next_a_in_v;
    bool tells_velocities;  ///< else it has some of its own, at other times
    const char* words;
};

constexpr std::array<Method, 13> methods{{
    {0.0, 1.0, 0.0, true, "explicit Euler: the atoms move by r += v dt, v += a(t) dt"},
    {0.5, 0.5, 0.0, true,
     "second half kick: it is missing; after r += v dt come the new forces and v += a(t + dt) dt/2"},
    {0.5, 0.5, 1.0, true, "second half kick: it is a whole one, v += a(t + dt) dt, where it is to be dt/2"},
    {0.0, 0.0, 0.5, true, "first half kick: it is missing; before r += v dt comes v += a(t) dt/2"},
    {1.0, 1.0, 0.5, true, "first half kick: it is a whole one, v += a(t) dt, where it is to be dt/2"},
    {1.0, 0.5, 0.5, true, "half of a dt^2: the atoms move by r += v dt + a dt^2, where it is to be a dt^2/2"},
    {0.0, 0.5, 0.5, true, "half of a dt^2: the atoms move by r += v dt alone, without a dt^2/2"},
    {0.5, 1.0, 0.0, true, "old forces: velocities change by a(t) dt, where it is to be (a(t) + a(t + dt)) dt/2"},
    {0.5, 0.0, 1.0, true, "new forces: velocities change by a(t + dt) dt, where it is to be (a(t) + a(t + dt)) dt/2"},
    {0.5, 1.0, 1.0, true, "both kicks: velocities change by (a(t) + a(t + dt)) dt, where it is to be half of it"},
    {1.0, 1.0, 1.0, true, "mass: the atoms are where forces take them if their mass is 0.5, where it is 1"},
    {1.0, 1.0, 0.0, false,
     "half-step start: at step 1 the atoms are a(0) dt^2/2 too far, and go on so: the velocities of the start, of t = "
     "0, were taken for those of t = -dt/2"},
    {0.0, 0.0, 1.0, false,
     "half-step start: at step 1 the atoms are a(0) dt^2/2 too near, and go on so: the velocities of the start, of t = "
     "0, were taken for those of t = +dt/2"},
}};
constexpr Method velocity_verlet{
    0.5, 0.5, 0.5, true,
    "other velocities at the start: the atoms move with the velocities of the frame of step 0, which are not those of "
    "start.xyz"};

/// A frame that a method has to explain: how far it may be from it.
struct Aim {
    const JudgedFrame* frame;
    std::vector<Vec3> places;  ///< nearest to ours
    double distance;           ///< of all atoms together
    double velocity;           ///< infinite if there are none
};

std::vector<Aim> aims_of(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    std::vector<Aim> aims;
    for (const JudgedFrame& frame : trajectory.frames) {
        const auto limit = limit_at(agreement.positions, frame.step);
        if (frame.step < 1 || frame.step > last_step_of_a_method || !limit || frame.our_positions.empty() ||
            aims.size() == frames_of_a_method) {
            continue;
        }
        const double root = std::sqrt(static_cast<double>(frame.positions.size()));
        Aim aim{&frame, nearest_to_ours(frame, trajectory.edges), 0.0, INFINITY};
        aim.distance =
            std::max(*limit * root, unexplained_of_frames * distance(aim.places, 0.0, aim.places, frame.our_positions));
        if (!frame.velocities.empty() && !frame.our_velocities.empty()) {
            aim.velocity = std::max(
                *velocity_limit(agreement, frame.step, trajectory.time_step) * root,
                unexplained_of_frames * distance(frame.velocities, 0.0, frame.velocities, frame.our_velocities));
        }
        aims.push_back(std::move(aim));
    }
    return aims;
}

/// Whether a method from the start comes to all aims.
class Follower {
  public:
    Follower(const Fluid& fluid, ForceField& force_field, const Execution& execution, double time_step)
        : fluid_(fluid), force_field_(force_field), execution_(execution), dt_(time_step) {}

    [[nodiscard]] bool reaches(const std::vector<Aim>& aims, const Method& method,
                               const std::vector<Vec3>& velocities) const try {
        std::vector<Vec3> r = fluid_.positions;
        std::vector<Vec3> v = velocities;
        std::vector<Vec3> a = forces(r);
        Index step = 0;
        for (const Aim& aim : aims) {
            for (; step < aim.frame->step; ++step) {
                for (std::size_t i = 0; i < r.size(); ++i) {
                    r[i] += dt_ * v[i] + method.a_in_r * dt_ * dt_ * a[i];
                    v[i] += method.a_in_v * dt_ * a[i];
                }
                a = forces(r);
                for (std::size_t i = 0; i < r.size(); ++i) {
                    v[i] += method.next_a_in_v * dt_ * a[i];
                }
            }
            JudgedFrame there{.step = step, .positions = r, .our_positions = aim.places};
            const std::vector<Vec3> places = nearest_to_ours(there, fluid_.edges);
            if (!(distance(places, 0.0, places, aim.places) <= aim.distance)) {
                return false;
            }
            if (method.tells_velocities && std::isfinite(aim.velocity) &&
                !(distance(v, 0.0, v, aim.frame->velocities) <= aim.velocity)) {
                return false;
            }
        }
        return !aims.empty();
    } catch (const PhysicsError&) {
        return false;  // it loses its atoms
    }

  private:
    [[nodiscard]] std::vector<Vec3> forces(const std::vector<Vec3>& positions) const {
        return forces_at(fluid_, positions, force_field_, execution_);
    }

    const Fluid& fluid_;
    ForceField& force_field_;
    const Execution& execution_;
    double dt_;
};

bool is_right(const JudgedFrame& frame, const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const auto limit = limit_at(agreement.positions, frame.step);
    return !limit || frame.our_positions.empty() || largest_distance(frame, trajectory.edges) <= *limit;
}

}  // namespace

bool starts_with_other_velocities(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const JudgedFrame* start = frame_of(trajectory, 0);
    const auto limit = velocity_limit(agreement, 0, trajectory.time_step);
    return start != nullptr && limit && !start->velocities.empty() && !start->our_velocities.empty() &&
           !(largest_velocity_difference(*start) <= *limit);
}

std::string wrong_method(const JudgedTrajectory& trajectory, const Fluid& fluid, ForceField& force_field,
                         const Execution& execution, const Agreement& agreement) {
    const bool moves_rightly = std::ranges::all_of(
        trajectory.frames, [&](const JudgedFrame& frame) { return is_right(frame, trajectory, agreement); });
    if (moves_rightly) {
        return "";
    }
    const std::vector<Aim> aims = aims_of(trajectory, agreement);
    const Follower follower(fluid, force_field, execution, trajectory.time_step);
    if (starts_with_other_velocities(trajectory, agreement)) {
        const JudgedFrame& start = *frame_of(trajectory, 0);
        return follower.reaches(aims, velocity_verlet, start.velocities) ? velocity_verlet.words : "";
    }
    const auto found = std::ranges::find_if(
        methods, [&](const Method& method) { return follower.reaches(aims, method, fluid.velocities); });
    return found == methods.end() ? "" : found->words;
}

}  // namespace ljmd
