#include "judge/velocity_diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "judge/explanations.hpp"

namespace ljmd {

namespace {

using Vectors = std::vector<Vec3>;

double distance_of(const Vectors& a, const Vectors& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        squares += (a[i] - b[i]).squaredNorm();
    }
    return std::sqrt(squares);
}

/// Each vector changed by a function.
template <class Change>
Vectors changed(Vectors vectors, const Change& change) {
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        vectors[i] = change(vectors[i], i);
    }
    return vectors;
}

/// The velocities of one frame beside ours.
class Velocities {
  public:
    /// @param moves_on  whether the motion is right: velocities of another time do no harm to it
    Velocities(const JudgedFrame& frame, double time_step, double noise, bool moves_on)
        : frame_(frame),
          moves_on_(moves_on),
          theirs_(frame.velocities),
          ours_(frame.our_velocities),
          time_step_(time_step),
          noise_(noise * std::sqrt(static_cast<double>(ours_.size()))),
          known_(distance_of(theirs_, ours_), noise_, unexplained_part) {}

    /// The mistake that explains most.
    [[nodiscard]] std::optional<std::string> mistake() {
        if (!known_.is_wrong()) {
            return std::nullopt;
        }
        if (moves_on_) {
            other_times();
        }
        factors();
        axes();
        one_atom(noise_ / std::sqrt(static_cast<double>(ours_.size())));
        constant();
        other_rows();
        return known_.best();
    }

  private:
    static constexpr double unexplained_part = 1e-2;

    void meant(const Vectors& velocities, const std::string& words) {
        known_.offer(distance_of(theirs_, velocities), words);
    }

    void other_times() {
        const Vectors& a = frame_.our_forces;
        for (const double side : {-1.0, 1.0}) {
            // v' - side a dt/2 is the velocity at the time of the positions, if v' is at t + side dt/2.
            meant(changed(ours_,
                          [&](const Vec3& v, std::size_t i) -> Vec3 { return v + side * 0.5 * time_step_ * a[i]; }),
                  fmt::format("half-step velocities: in the frame of step {} velocities are those of half a time step "
                              "{}: v(t) = v' {} a(t) dt/2",
                              frame_.step, side < 0.0 ? "earlier" : "later", side < 0.0 ? "+" : "-"));
        }
        for (const auto& [motion, word] : {std::pair(&frame_.before, "late"), std::pair(&frame_.after, "early")}) {
            if (!motion->velocities.empty()) {
                meant(motion->velocities,
                      fmt::format("one step {}: velocities in the frame of step {} are those of step {}", word,
                                  frame_.step, frame_.step + (motion == &frame_.before ? -1 : 1)));
            }
        }
    }

    void factors() {
        double along = 0.0;
        double squares = 0.0;
        for (std::size_t i = 0; i < ours_.size(); ++i) {
            along += theirs_[i].dot(ours_[i]);
            squares += ours_[i].squaredNorm();
        }
        const auto times = [&](double c) {
            return changed(ours_, [&](const Vec3& v, std::size_t) -> Vec3 { return c * v; });
        };
        meant(times(-1.0), about("have the wrong sign"));
        meant(times(0.0), about("are all zero"));
        if (squares > 0.0) {
            const double c = along / squares;
            meant(times(c), about(fmt::format("are {:.10g} times the right ones", c)));
        }
    }

    /// Each axis may stand in the place of another, and have the other sign.
    void axes() {
        std::array<int, 3> axis{0, 1, 2};
        do {
            for (unsigned signs = 0; signs < 8; ++signs) {
                const bool same = axis == std::array{0, 1, 2};
                if (same && (signs == 0 || signs == 7)) {
                    continue;  // right ones, and all of the wrong sign
                }
                const auto component = [&](const Vec3& v, int k) {
                    return ((signs >> static_cast<unsigned>(k)) & 1U) != 0 ? -v[axis[static_cast<std::size_t>(k)]]
                                                                           : v[axis[static_cast<std::size_t>(k)]];
                };
                std::string form;
                for (int k = 0; k < 3; ++k) {
                    form += fmt::format("{}{}v{}", k > 0 ? ", " : "",
                                        ((signs >> static_cast<unsigned>(k)) & 1U) != 0 ? "-" : "",
                                        "xyz"[axis[static_cast<std::size_t>(k)]]);
                }
                meant(changed(ours_,
                              [&](const Vec3& v, std::size_t) -> Vec3 {
                                  return {component(v, 0), component(v, 1), component(v, 2)};
                              }),
                      about(fmt::format("stand in other columns, as ({})", form)));
            }
        } while (std::next_permutation(axis.begin(), axis.end()));
    }

    void constant() {
        Vec3 mean = Vec3::Zero();
        for (std::size_t i = 0; i < ours_.size(); ++i) {
            mean += (theirs_[i] - ours_[i]) / static_cast<double>(ours_.size());
        }
        meant(changed(ours_, [&](const Vec3& v, std::size_t) -> Vec3 { return v + mean; }),
              about(fmt::format("have ({:.6g}, {:.6g}, {:.6g}) added on every atom: the whole moves", mean[0], mean[1],
                                mean[2])));
    }

    /// One atom that is wrong explains nothing where all others are not right.
    void one_atom(double noise) {
        std::size_t wrong = 0;
        std::size_t last = 0;
        for (std::size_t i = 0; i < ours_.size(); ++i) {
            if (!((theirs_[i] - ours_[i]).norm() <= noise)) {
                ++wrong;
                last = i;
            }
        }
        if (wrong == 1 && ours_.size() > 1) {
            known_.offer(0.0, about(fmt::format("are right but for one atom, the one of id {}", last + 1)));
        }
    }

    /// Velocities that are those of other atoms: sorted by their first components, each is looked for among ours.
    void other_rows() {
        std::vector<std::size_t> order(ours_.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::ranges::sort(order, {}, [&](std::size_t i) { return ours_[i][0]; });
        const double same = noise_ / std::sqrt(static_cast<double>(ours_.size()));
        std::size_t moved = 0;
        std::vector<bool> taken(ours_.size(), false);
        for (std::size_t i = 0; i < theirs_.size(); ++i) {
            auto place =
                std::ranges::lower_bound(order, theirs_[i][0] - same, {}, [&](std::size_t k) { return ours_[k][0]; });
            while (place != order.end() && ours_[*place][0] <= theirs_[i][0] + same &&
                   (taken[*place] || !((ours_[*place] - theirs_[i]).norm() <= same))) {
                ++place;
            }
            if (place == order.end() || ours_[*place][0] > theirs_[i][0] + same) {
                return;  // of no atom
            }
            taken[*place] = true;
            moved += *place == i ? 0U : 1U;
        }
        known_.offer(0.0,
                     fmt::format("another order: in the frame of step {}, velocities of {} of {} atoms stand in the "
                                 "rows of other atoms",
                                 frame_.step, moved, ours_.size()));
    }

    [[nodiscard]] std::string about(const std::string& what) const {
        return fmt::format("velocities: in the frame of step {} they {}", frame_.step, what);
    }

    const JudgedFrame& frame_;
    bool moves_on_;
    const Vectors& theirs_;
    const Vectors& ours_;
    double time_step_;
    double noise_;  ///< root of the sum of squares over atoms
    Explanations known_;
};

}  // namespace

std::optional<std::string> diagnose_velocities(const JudgedTrajectory& trajectory, const Agreement& agreement) {
    const bool moves_on = std::ranges::all_of(trajectory.frames, [&](const JudgedFrame& frame) {
        const auto limit = limit_at(agreement.positions, frame.step);
        return !limit || frame.our_positions.empty() || largest_distance(frame, trajectory.edges) <= *limit;
    });
    for (const JudgedFrame& frame : trajectory.frames) {
        const auto limit = velocity_limit(agreement, frame.step, trajectory.time_step);
        if (!limit || frame.velocities.empty() || frame.our_velocities.empty() ||
            !(largest_distance(frame, trajectory.edges) <= *limit_at(agreement.positions, frame.step))) {
            continue;  // where atoms are elsewhere, velocities are other ones
        }
        if (auto words = Velocities(frame, trajectory.time_step, *limit, moves_on).mistake()) {
            return words;
        }
    }
    return std::nullopt;
}

}  // namespace ljmd
