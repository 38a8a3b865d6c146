#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ljmd/compare/judge/frame_judgement.hpp"
#include "ljmd/compare/judge/near_pairs.hpp"
#include "ljmd/compare/judge/net_force.hpp"
#include "ljmd/compare/judge/velocity_diagnosis.hpp"

namespace ljmd {

namespace {

/// A mistake is found if it explains all of a difference but this part.
constexpr double unexplained_of_frames = 1e-2;

/// The pairs among atoms with wrong forces, as far as a system of equations is solved for them.
constexpr std::size_t most_pairs = 400;

double root_of_squares(const std::vector<Vec3>& vectors) {
    double sum = 0.0;
    for (const Vec3& v : vectors) {
        sum += v.squaredNorm();
    }
    return std::sqrt(sum);
}

/// a + c b - d, summed in squares.
double distance(const std::vector<Vec3>& a, double c, const std::vector<Vec3>& b, const std::vector<Vec3>& d) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] + c * b[i] - d[i]).squaredNorm();
    }
    return std::sqrt(sum);
}

const JudgedFrame* frame_of(const JudgedTrajectory& trajectory, Index step) {
    const auto found = std::ranges::find(trajectory.frames, step, &JudgedFrame::step);
    return found == trajectory.frames.end() ? nullptr : &*found;
}

/// Positions of an engine as those images that are nearest to ours.
std::vector<Vec3> nearest_to_ours(const JudgedFrame& frame, const Vec3& edges) {
    std::vector<Vec3> places;
    places.reserve(frame.positions.size());
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Vec3 apart = frame.positions[i] - frame.our_positions[i];
        const Vec3 images = (apart.array() / edges.array()).round();
        places.emplace_back(frame.positions[i] - images.cwiseProduct(edges));
    }
    return places;
}

/// What the first step tells: the start's velocities were taken for velocities at another time, or the time step is
/// another.
std::string first_step(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const JudgedFrame* start = frame_of(trajectory, 0);
    const JudgedFrame* frame = frame_of(trajectory, 1);
    if (start == nullptr || frame == nullptr || start->our_positions.empty() || frame->our_positions.empty()) {
        return "";
    }
    const std::vector<Vec3> places = nearest_to_ours(*frame, trajectory.edges);
    const double dt = trajectory.time_step;
    const double off = distance(places, 0.0, places, frame->our_positions);
    const double noise = agreement.positions.empty() ? 0.0 : agreement.positions.front().distance;
    if (!(off > noise * std::sqrt(static_cast<double>(places.size())))) {
        return "";
    }
    const double kick = 0.5 * dt * dt;
    for (const double side : {-1.0, 1.0}) {
        if (distance(places, -side * kick, start->our_forces, frame->our_positions) < unexplained_of_frames * off) {
            return fmt::format(
                "half-step start: at step 1 the atoms are a(0) dt^2/2 {}: the velocities of the start, of t = 0, were "
                "taken for those of t = {}dt/2",
                side > 0.0 ? "too far" : "too near", side > 0.0 ? "-" : "+");
        }
    }
    // r'(1) - r(0) = v dt' + a dt'^2/2, by Newton's method from dt.
    double other = dt;
    std::vector<Vec3> slope(places.size());
    std::vector<Vec3> rest(places.size());
    for (int k = 0; k < 20; ++k) {
        double a = 0.0;
        double b = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Vec3& v = start->our_velocities[i];
            const Vec3& f = start->our_forces[i];
            slope[i] = v + other * f;
            rest[i] = places[i] - start->our_positions[i] - other * v - 0.5 * other * other * f;
            a += slope[i].dot(rest[i]);
            b += slope[i].squaredNorm();
        }
        other += b > 0.0 ? a / b : 0.0;
    }
    if (root_of_squares(rest) < unexplained_of_frames * off) {
        return fmt::format(
            "another time step: at step 1 the atoms are where a time step of {:.10g} takes them, where it is {:g}",
            other, dt);
    }
    return "";
}

/// Forces of a frame that are wrong, as far as pairs within the cutoff explain them.
class MissingPairs {
  public:
    MissingPairs(const JudgedFrame& frame, const Vec3& edges, const PairPotential& potential, double noise)
        : pairs_(frame.positions, edges, potential.cutoff().radius) {
        for (std::size_t i = 0; i < frame.forces.size(); ++i) {
            lacking_.emplace_back(frame.forces_there[i] - frame.forces[i]);
            wrong_.push_back(!(lacking_[i].norm() <= noise));
        }
        for (const NearPairs::Pair& pair : pairs_.pairs()) {
            if (wrong_[pair.i] && wrong_[pair.j]) {
                candidates_.push_back(pair);
                forces_.emplace_back(potential(pair.distance).w * pair.separation);
            }
        }
    }

    [[nodiscard]] Index wrong_atoms() const { return std::ranges::count(wrong_, true); }

    /// Number of missing pairs if those are missing that were farthest apart in an earlier frame; 0 if that explains
    /// nothing.
    [[nodiscard]] std::size_t farthest_in(const JudgedFrame& earlier, const Vec3& edges) const {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            const Vec3 apart = earlier.positions[candidates_[k].i] - earlier.positions[candidates_[k].j];
            const Vec3 images = (apart.array() / edges.array()).round();
            order.emplace_back(-(apart - images.cwiseProduct(edges)).norm(), k);
        }
        std::ranges::sort(order);
        std::vector<Vec3> rest = lacking_;
        double least = unexplained_of_frames * root_of_squares(rest);
        std::size_t missing = 0;
        for (std::size_t n = 0; n < order.size(); ++n) {
            take_off(rest, order[n].second, 1.0);
            if (const double left = root_of_squares(rest); left < least) {
                least = left;
                missing = n + 1;
            }
        }
        return missing;
    }

    /// Number of missing pairs if every pair of wrong atoms is there or missing: least squares for the part of each
    /// pair that is missing. 0 if parts are not 0 or 1, or if there are too many pairs to tell.
    [[nodiscard]] std::size_t of_any() const {
        if (candidates_.empty() || candidates_.size() > most_pairs) {
            return 0;
        }
        Eigen::MatrixXd matrix =
            Eigen::MatrixXd::Zero(static_cast<Index>(3 * lacking_.size()), std::ssize(candidates_));
        Eigen::VectorXd right(static_cast<Index>(3 * lacking_.size()));
        for (std::size_t i = 0; i < lacking_.size(); ++i) {
            right.segment<3>(static_cast<Index>(3 * i)) = lacking_[i];
        }
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            matrix.block<3, 1>(static_cast<Index>(3 * candidates_[k].i), static_cast<Index>(k)) = forces_[k];
            matrix.block<3, 1>(static_cast<Index>(3 * candidates_[k].j), static_cast<Index>(k)) = -forces_[k];
        }
        const Eigen::VectorXd parts = matrix.colPivHouseholderQr().solve(right);
        std::vector<Vec3> rest = lacking_;
        std::size_t missing = 0;
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            const double part = parts[static_cast<Index>(k)];
            if (std::abs(part - std::round(part)) > unexplained_of_frames) {
                return 0;
            }
            missing += std::round(part) == 1.0 ? 1 : 0;
            take_off(rest, k, std::round(part));
        }
        return root_of_squares(rest) < unexplained_of_frames * root_of_squares(lacking_) ? missing : 0;
    }

  private:
    void take_off(std::vector<Vec3>& rest, std::size_t k, double part) const {
        rest[candidates_[k].i] -= part * forces_[k];
        rest[candidates_[k].j] += part * forces_[k];
    }

    NearPairs pairs_;
    std::vector<Vec3> lacking_;  ///< F - F' of each atom
    std::vector<bool> wrong_;
    std::vector<NearPairs::Pair> candidates_;  ///< between wrong atoms
    std::vector<Vec3> forces_;                 ///< of the candidates
};

double largest_difference(const JudgedFrame& frame) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.forces.size(); ++i) {
        largest = larger_or_nan(largest, (frame.forces[i] - frame.forces_there[i]).norm());
    }
    return largest;
}

/// What rounding leaves of a difference of forces in a frame. Each frame has its own: where atoms collide because of a
/// mistake, forces are larger by powers of ten.
double noise_of(const JudgedFrame& frame, double tolerance) {
    if (frame.forces_there.empty()) {
        return 0.0;
    }
    const double rms = root_of_squares(frame.forces_there) / std::sqrt(static_cast<double>(frame.forces_there.size()));
    return tolerance * std::max(rms, 1e-9);
}

/// Whether the forces of the frame are right for its positions. @param tolerance  relative to their root mean square
bool has_right_forces(const JudgedFrame& frame, double tolerance) {
    return !frame.forces.empty() && largest_difference(frame) <= noise_of(frame, tolerance);
}

std::string stale_list(const JudgedTrajectory& trajectory, const PairPotential& potential, double tolerance) {
    const auto wrong = std::ranges::find_if(trajectory.frames, [&](const JudgedFrame& frame) {
        return !frame.forces.empty() && !has_right_forces(frame, tolerance);
    });
    const auto right = std::ranges::find_if(
        trajectory.frames, [&](const JudgedFrame& frame) { return has_right_forces(frame, tolerance); });
    if (wrong == trajectory.frames.end() || right >= wrong) {
        return "";
    }
    const double noise_of_all = noise_of(*wrong, tolerance) * std::sqrt(static_cast<double>(wrong->forces.size()));
    if (const auto words = net_force(wrong->forces, wrong->forces_there, noise_of_all)) {
        return fmt::format("at step {}, {}", wrong->step, *words);
    }
    const MissingPairs lacking(*wrong, trajectory.edges, potential, noise_of(*wrong, tolerance));
    std::size_t missing = 0;
    for (auto earlier = trajectory.frames.begin(); earlier != wrong && missing == 0; ++earlier) {
        missing = lacking.farthest_in(*earlier, trajectory.edges);
    }
    if (missing == 0) {
        missing = lacking.of_any();
    }
    if (missing > 0) {
        return fmt::format(
            "stale list: forces are right at step {}, and at step {} those of {} pair{} within the cutoff are missing, "
            "on {} "
            "atoms: a neighbour list that is built too seldom, or too short",
            right->step, wrong->step, missing, missing == 1 ? "" : "s", lacking.wrong_atoms());
    }
    return fmt::format(
        "stale list or state: forces are right at step {}, and at step {} wrong on {} of {} atoms: they are not those "
        "of "
        "the positions beside them",
        right->step, wrong->step, lacking.wrong_atoms(), wrong->forces.size());
}

/// Atoms of the first frame that stand in the places of others.
std::string another_order(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const JudgedFrame* first = frame_of(trajectory, 0);
    constexpr double same_place = 1e-6;  // where no limit is given for the start
    const double limit = limit_at(agreement.positions, 0).value_or(same_place);
    if (first == nullptr || first->our_positions.empty() || largest_distance(*first, trajectory.edges) <= limit) {
        return "";
    }
    std::size_t moved = 0;
    for (std::size_t i = 0; i < first->positions.size(); ++i) {
        const auto stands_at = [&](const Vec3& place) {
            const Vec3 apart = first->positions[i] - place;
            const Vec3 images = (apart.array() / trajectory.edges.array()).round();
            return (apart - images.cwiseProduct(trajectory.edges)).norm() <= limit;
        };
        if (stands_at(first->our_positions[i])) {
            continue;
        }
        if (std::ranges::none_of(first->our_positions, stands_at)) {
            return "";
        }
        ++moved;
    }
    return fmt::format(
        "another order: at step 0, {} of {} atoms stand in the places of others: rows are not in the order "
        "of the ids, or the ids are not those of start.xyz",
        moved, first->positions.size());
}

/// Positions that differ where all forces are right.
std::string integration(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    for (const JudgedFrame& frame : trajectory.frames) {
        if (!frame.forces.empty() && !has_right_forces(frame, agreement.largest_force)) {
            return "";
        }
        const auto limit = limit_at(agreement.positions, frame.step);
        if (limit && !frame.our_positions.empty() && !(largest_distance(frame, trajectory.edges) <= *limit)) {
            return frame.forces.empty()
                       ? ""
                       : fmt::format(
                             "integration: at step {} atoms are elsewhere, though forces are right where they are: the "
                             "method is not velocity Verlet or leapfrog, or its numbers are coarse",
                             frame.step);
        }
    }
    return "";
}

}  // namespace

std::vector<std::string> diagnose_trajectory(const JudgedTrajectory& trajectory, const PairPotential& potential,
                                             const Agreement& agreement) {
    if (const std::string words = another_order(trajectory, agreement); !words.empty()) {
        return {words};  // everything else follows from it
    }
    std::vector<std::string> words;
    const auto note = [&](const std::string& sentence) {
        if (!sentence.empty()) {
            words.push_back(sentence);
        }
    };
    note(first_step(trajectory, agreement));
    note(diagnose_velocities(trajectory, agreement).value_or(""));
    note(stale_list(trajectory, potential, agreement.largest_force));
    if (words.empty()) {
        note(integration(trajectory, agreement));
    }
    return words;
}

}  // namespace ljmd
