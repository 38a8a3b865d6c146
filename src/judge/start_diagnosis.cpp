#include "judge/start_diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "judge/explanations.hpp"
#include "judge/few_digits.hpp"
#include "judge/frame_vectors.hpp"

namespace ljmd {

namespace {

/// What the first step tells: how far atoms have moved by v(0) and by a(0).
class FirstStep {
  public:
    FirstStep(const JudgedFrame& start, const JudgedFrame& frame, const Vec3& edges, double time_step, double noise)
        : start_(start),
          frame_(frame),
          places_(nearest_to_ours(frame, edges)),
          dt_(time_step),
          noise_(noise * std::sqrt(static_cast<double>(places_.size()))),
          known_(distance(places_, 0.0, places_, frame.our_positions), noise_, unexplained_of_frames) {}

    [[nodiscard]] std::string mistake() {
        if (known_.is_wrong()) {
            one_atom();
            another_mass();  // where velocities say so; it has the same places as a start half a step off, if m = 1/2
            another_time_step();
        }
        return known_.best().value_or("");
    }

  private:
    /// r'(1) = r(0) + v(0) dt + a(0) dt^2/(2 m), by least squares for 1/m; and v'(1) = v(0) + (F(0) + F'(1)) dt/(2 m),
    /// which tells it from a start half a step off.
    void another_mass() {
        const auto [inverse, left] = along_forces(start_.our_forces, [](std::size_t) { return true; });
        if (!(inverse > 0.0) || frame_.velocities.empty() || frame_.forces_there.empty()) {
            return;
        }
        double off = 0.0;
        double all = 0.0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const Vec3 kick = 0.5 * dt_ * (start_.our_forces[i] + frame_.forces_there[i]);
            off += (frame_.velocities[i] - start_.our_velocities[i] - inverse * kick).squaredNorm();
            all += ((inverse - 1.0) * kick).squaredNorm();
        }
        if (off <= unexplained_of_frames * unexplained_of_frames * all) {
            known_.offer(left,
                         fmt::format("mass: at step 1 the atoms are where forces take them if their mass is {:.8g}, "
                                     "where it is 1",
                                     1.0 / inverse));
        }
    }

    /// r'(1) - r(0) = v dt' + a dt'^2/2, by Newton's method from dt.
    void another_time_step() {
        double other = dt_;
        std::vector<Vec3> slope(places_.size());
        std::vector<Vec3> rest(places_.size());
        for (int k = 0; k < 20; ++k) {
            double a = 0.0;
            double b = 0.0;
            for (std::size_t i = 0; i < places_.size(); ++i) {
                const Vec3& v = start_.our_velocities[i];
                const Vec3& f = start_.our_forces[i];
                slope[i] = v + other * f;
                rest[i] = places_[i] - start_.our_positions[i] - other * v - 0.5 * other * other * f;
                a += slope[i].dot(rest[i]);
                b += slope[i].squaredNorm();
            }
            other += b > 0.0 ? a / b : 0.0;
        }
        known_.offer(root_of_squares(rest),
                     fmt::format("another time step: at step 1 the atoms are where a time step of {:.10g} takes them, "
                                 "where it is {:g}",
                                 other, dt_));
    }

    /// One atom alone is elsewhere.
    void one_atom() {
        const double limit = noise_ / std::sqrt(static_cast<double>(places_.size()));
        std::size_t wrong = 0;
        std::size_t last = 0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (!((places_[i] - frame_.our_positions[i]).norm() <= limit)) {
                ++wrong;
                last = i;
            }
        }
        if (wrong != 1 || places_.size() == 1) {
            return;
        }
        const auto [inverse, left] = along_forces(start_.our_forces, [&](std::size_t i) { return i == last; });
        known_.offer(0.0, fmt::format("one atom: at step 1 the one of id {} alone is elsewhere{}", last + 1,
                                      inverse > 0.0 && left <= std::max(noise_, unexplained_of_frames * off_of(last))
                                          ? fmt::format(", where forces take it if its mass is {:.8g}", 1.0 / inverse)
                                          : ""));
    }

    [[nodiscard]] double off_of(std::size_t i) const { return (places_[i] - frame_.our_positions[i]).norm(); }

    /// The c of r'(1) = r(0) + v(0) dt + c F(0) dt^2/2 of some atoms, and the distance that it leaves.
    template <class IsAmong>
    [[nodiscard]] std::pair<double, double> along_forces(const std::vector<Vec3>& forces,
                                                         const IsAmong& is_among) const {
        // ours is r(0) + v(0) dt + F(0) dt^2/2, but for rounding
        const auto by_force = [&](std::size_t i) -> Vec3 { return 0.5 * dt_ * dt_ * forces[i]; };
        const auto moved = [&](std::size_t i) -> Vec3 { return places_[i] - frame_.our_positions[i] + by_force(i); };
        double along = 0.0;
        double squares = 0.0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (is_among(i)) {
                along += moved(i).dot(by_force(i));
                squares += by_force(i).squaredNorm();
            }
        }
        const double c = squares > 0.0 ? along / squares : 0.0;
        double left = 0.0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (is_among(i)) {
                left += (moved(i) - c * by_force(i)).squaredNorm();
            }
        }
        return {c, std::sqrt(left)};
    }

    const JudgedFrame& start_;
    const JudgedFrame& frame_;
    std::vector<Vec3> places_;  ///< of the engine, nearest to ours
    double dt_;
    double noise_;  ///< root of the sum of squares over atoms
    Explanations known_;
};

/// A start that lost digits when it was read, or one atom of it that stands elsewhere.
std::string other_start(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const JudgedFrame* first = frame_of(trajectory, 0);
    const auto limit = limit_at(agreement.positions, 0);
    if (first == nullptr || !limit || first->our_positions.empty() ||
        largest_distance(*first, trajectory.edges) <= *limit) {
        return "";
    }
    const std::vector<Vec3> places = nearest_to_ours(*first, trajectory.edges);
    std::size_t wrong = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!((places[i] - first->our_positions[i]).norm() <= *limit)) {
            ++wrong;
            last = i;
        }
    }
    if (wrong == 1 && places.size() > 1) {
        const Vec3 by = places[last] - first->our_positions[last];
        return fmt::format("one atom: at step 0 the one of id {} alone is elsewhere, by ({:.6g}, {:.6g}, {:.6g})",
                           last + 1, by[0], by[1], by[2]);
    }
    Explanations known(distance(places, 0.0, places, first->our_positions),
                       *limit * std::sqrt(static_cast<double>(places.size())), unexplained_of_frames);
    for (const Rounding& way : roundings()) {
        std::vector<Vec3> rounded = first->our_positions;
        for (Vec3& r : rounded) {
            r = r.unaryExpr(way.round);
        }
        known.offer(
            distance(places, 0.0, places, rounded),
            fmt::format("digits of the start: the positions of step 0 are those of start.xyz with {}", way.words));
    }
    return known.best().value_or("");
}

/// Whether positions are off while two trajectories are together.
bool has_failed(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    return std::ranges::any_of(trajectory.frames, [&](const JudgedFrame& frame) {
        const auto limit = limit_at(agreement.positions, frame.step);
        return limit && !frame.our_positions.empty() && !(largest_distance(frame, trajectory.edges) <= *limit);
    });
}

/// Frames whose numbers have few digits, if that is all that is wrong with their positions.
std::string digits_of_frames(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    std::vector<Vec3> numbers;
    for (const JudgedFrame& frame : trajectory.frames) {
        numbers.insert(numbers.end(), frame.positions.begin(), frame.positions.end());
    }
    const auto digits = digits_of(numbers);
    const JudgedFrame& first = trajectory.frames.front();
    const auto way = std::ranges::find(roundings(), digits.value_or(""), &Rounding::words);
    if (way == roundings().end() || first.our_positions.empty()) {
        return "";
    }
    double step = 0.0;  // that a coordinate is rounded by
    for (const Vec3& r : first.our_positions) {
        step = std::max(step, (r.unaryExpr(way->round) - r).cwiseAbs().maxCoeff());
    }
    const bool is_all = std::ranges::all_of(trajectory.frames, [&](const JudgedFrame& frame) {
        return !limit_at(agreement.positions, frame.step) || largest_distance(frame, trajectory.edges) <= 4.0 * step;
    });
    return is_all ? fmt::format("few digits: positions of the frames have {}; 17 significant digits are exact", *digits)
                  : "";
}

}  // namespace

std::string first_step(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const JudgedFrame* start = frame_of(trajectory, 0);
    const JudgedFrame* frame = frame_of(trajectory, 1);
    if (start == nullptr || frame == nullptr || start->our_positions.empty() || frame->our_positions.empty()) {
        return "";
    }
    const double noise = agreement.positions.empty() ? 0.0 : agreement.positions.front().distance;
    return FirstStep(*start, *frame, trajectory.edges, trajectory.time_step, noise).mistake();
}

std::string other_digits(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    if (!has_failed(trajectory, agreement)) {
        return "";
    }
    const std::string words = digits_of_frames(trajectory, agreement);
    return words.empty() ? other_start(trajectory, agreement) : words;
}

}  // namespace ljmd
