#include "judge/frame_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ljmd {

namespace {

/// Forces below this are rounding errors of a vanishing sum.
constexpr double vanishing_force_of_frame = 1e-9;

constexpr double fastest_motion = 40.0;  // [1/tau]

double kinetic_energy(const std::vector<Vec3>& velocities) {
    double twice = 0.0;
    for (const Vec3& v : velocities) {
        twice += v.squaredNorm();
    }
    return 0.5 * twice;
}

/// Root mean square length of the vectors.
double root_mean_square(const std::vector<Vec3>& vectors) {
    return std::sqrt(2.0 * kinetic_energy(vectors) / static_cast<double>(vectors.size()));
}

}  // namespace

double largest_distance(const JudgedFrame& frame, const Vec3& edges) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Vec3 apart = frame.positions[i] - frame.our_positions[i];
        const Vec3 images = (apart.array() / edges.array()).round();
        largest = larger_or_nan(largest, (apart - images.cwiseProduct(edges)).norm());
    }
    return largest;
}

std::optional<double> velocity_limit(const Agreement& agreement, Index step, double time_step) {
    const auto distance = limit_at(agreement.positions, step);
    return distance ? std::optional(
                          std::max(fastest_motion * *distance, 2.0 * agreement.positions.front().distance / time_step))
                    : std::nullopt;
}

double largest_velocity_difference(const JudgedFrame& frame) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.velocities.size(); ++i) {
        largest = larger_or_nan(largest, (frame.velocities[i] - frame.our_velocities[i]).norm());
    }
    return largest;
}

double largest_force_difference(const JudgedFrame& frame) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.forces.size(); ++i) {
        largest = larger_or_nan(largest, (frame.forces[i] - frame.forces_there[i]).norm());
    }
    const double rms = root_mean_square(frame.forces_there);
    return largest / (rms > vanishing_force_of_frame ? rms : 1.0);
}

std::vector<Check> check_trajectory(const JudgedTrajectory& trajectory, const std::vector<Index>& judged,
                                    const Agreement& agreement) {
    std::vector<Check> checks;
    double kinetic_at_start = 0.0;
    for (const JudgedFrame& frame : trajectory.frames) {
        if (frame.step == 0) {
            kinetic_at_start = kinetic_energy(frame.our_velocities);
        }
        if (std::ranges::find(judged, frame.step) == judged.end()) {
            continue;
        }
        if (const auto limit = limit_at(agreement.positions, frame.step); limit && !frame.our_positions.empty()) {
            checks.push_back(
                {fmt::format("step {}: positions", frame.step), largest_distance(frame, trajectory.edges), *limit});
        }
        if (const auto limit = velocity_limit(agreement, frame.step, trajectory.time_step);
            limit && !frame.velocities.empty() && !frame.our_velocities.empty()) {
            const double atoms = static_cast<double>(frame.velocities.size());
            const double rms =
                std::sqrt(2.0 * std::max(kinetic_at_start, kinetic_energy(frame.our_velocities)) / atoms);
            const double unit = rms > 0.0 ? rms : 1.0;
            checks.push_back({fmt::format("step {}: velocities", frame.step), largest_velocity_difference(frame) / unit,
                              *limit / unit});
        }
        if (frame.step <= last_step_of_kinetic_energy && !frame.velocities.empty() && !frame.our_velocities.empty() &&
            std::isfinite(agreement.kinetic_energy)) {
            const double ours = kinetic_energy(frame.our_velocities);
            const double size = std::max(ours, kinetic_at_start);
            const double off = std::abs(kinetic_energy(frame.velocities) - ours);
            checks.push_back({fmt::format("step {}: kinetic energy", frame.step), size > 0.0 ? off / size : off,
                              agreement.kinetic_energy});
        }
        if (!frame.forces.empty()) {
            checks.push_back({fmt::format("step {}: forces at the engine's positions", frame.step),
                              largest_force_difference(frame), agreement.largest_force});
        }
    }
    return checks;
}

}  // namespace ljmd
