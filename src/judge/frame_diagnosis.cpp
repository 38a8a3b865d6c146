#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/frame_judgement.hpp"
#include "judge/frame_vectors.hpp"
#include "judge/method_diagnosis.hpp"
#include "judge/missing_pairs.hpp"
#include "judge/net_force.hpp"
#include "judge/start_diagnosis.hpp"
#include "judge/velocity_diagnosis.hpp"

namespace ljmd {

namespace {

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
    const MissingPairs lacking(wrong->positions, wrong->forces, wrong->forces_there, trajectory.edges, potential,
                               noise_of(*wrong, tolerance));
    std::size_t missing = 0;
    for (auto earlier = trajectory.frames.begin(); earlier != wrong && missing == 0; ++earlier) {
        missing = lacking.farthest_in(earlier->positions, trajectory.edges).size();
    }
    const std::string from = fmt::format("forces are right at step {}, and at step {}", right->step, wrong->step);
    if (missing > 0) {
        return fmt::format(
            "stale list: {} those of {} pair{} within the cutoff are missing, on {} atoms, which were the farthest "
            "apart "
            "before: a neighbour list that is built too seldom, or too short",
            from, missing, missing == 1 ? "" : "s", lacking.wrong_atoms());
    }
    if (const auto pairs = lacking.of_any(); !pairs.empty()) {
        return fmt::format(
            "missing pair: {} those of {} pair{} are missing, of the ids {} and {}{}, which were not the farthest "
            "apart "
            "before: pairs that are excluded, as bonded ones are, or that a list loses",
            from, pairs.size(), pairs.size() == 1 ? "" : "s", pairs.front().i + 1, pairs.front().j + 1,
            pairs.size() == 1 ? "" : " for one");
    }
    return fmt::format("stale state: {} wrong on {} of {} atoms: they are not those of the positions beside them", from,
                       lacking.wrong_atoms(), wrong->forces.size());
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
    if (starts_with_other_velocities(trajectory, agreement)) {
        return "";  // which take atoms elsewhere
    }
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

std::vector<std::string> diagnose_trajectory(const JudgedTrajectory& trajectory, const Fluid& fluid,
                                             ForceField& force_field, const Execution& execution,
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
    if (const std::string digits = other_digits(trajectory, agreement); !digits.empty()) {
        return {digits};  // the same
    }
    const JudgedFrame* start = frame_of(trajectory, 0);
    if (start == nullptr || start->forces.empty() || has_right_forces(*start, agreement.largest_force)) {
        // else it is the forces that take the atoms elsewhere
        note(wrong_method(trajectory, fluid, force_field, execution, agreement));
        if (words.empty()) {
            note(first_step(trajectory, agreement));
        }
    }
    if (words.empty() || starts_with_other_velocities(trajectory, agreement)) {
        note(diagnose_velocities(trajectory, agreement).value_or(""));
    }
    note(stale_list(trajectory, fluid.potential, agreement.largest_force));
    if (words.empty()) {
        note(integration(trajectory, agreement));
    }
    return words;
}

}  // namespace ljmd
