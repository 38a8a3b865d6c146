#include "engine/stability.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr double longest_move = 0.5;       // [sigma] in one step; atoms at 50 epsilon/k_B and 0.004 tau stay below 0.2
constexpr double energy_allowance = 0.1;   // [epsilon per atom]
constexpr double kinetic_allowance = 0.1;  // fraction of the kinetic energy, with which the integrator's errors grow
constexpr double pairs_crossing = 3.0;     // per atom, as when a crystal melts under a plain cut

/// The fastest atom so far. Of equally fast atoms the first counts; nothing is faster than a speed that is not finite.
struct Fastest {
    Index atom = 0;
    double speed2 = 0.0;

    void compare(Index i, double other) {
        if (std::isfinite(speed2) && !(other <= speed2)) {  // true for NaN as well
            atom = i;
            speed2 = other;
        }
    }
};

}  // namespace

StabilityWatch::StabilityWatch(double time_step, bool constant_energy, const PairPotential& potential)
    : time_step_(time_step),
      constant_energy_(constant_energy),
      jump_at_cutoff_(std::abs(potential(std::nextafter(potential.cutoff().radius, 0.0)).u)) {}

void StabilityWatch::check_speeds(const State& state) const {
    const auto v = state.velocities();
    const auto fastest_of = [&](Index first, Index last) {
        Fastest fastest;
        for (Index i = first; i < last; ++i) {
            fastest.compare(i, v.col(i).squaredNorm());
        }
        return fastest;
    };
    const Fastest fastest =
        join_blocks(state.execution(), state.count(), loop_block, Fastest{}, fastest_of,
                    [](Fastest& so_far, const Fastest& block) { so_far.compare(block.atom, block.speed2); });
    double move = std::sqrt(fastest.speed2) * time_step_;
    // Of several ranks, all find the same atom: the first one that moves farthest, NaN above all.
    Ranks& ranks = state.execution().ranks();
    const double here = std::isnan(move) ? std::numeric_limits<double>::infinity() : move;
    double farthest = here;
    ranks.largest({&farthest, 1});
    if (farthest < longest_move) {
        return;
    }
    double first_rank = here == farthest ? -ranks.rank() : -std::numeric_limits<double>::infinity();
    ranks.largest({&first_rank, 1});
    const bool is_ours = first_rank == -ranks.rank();
    std::array<std::int64_t, 2> named{0, 0};
    if (is_ours) {
        named = {state.ids()[static_cast<std::size_t>(fastest.atom)] + 1, std::bit_cast<std::int64_t>(move)};
    }
    ranks.sum(named);
    move = std::bit_cast<double>(named[1]);
    throw PhysicsError(
        fmt::format("atom {} moves {:.3g} sigma in one step of {:.6g} tau: the run has blown up. Is the "
                    "time step too large, or do atoms overlap at the start?",
                    named[0], move, time_step_));
}

void StabilityWatch::check_energy(const Thermodynamics& now) {
    if (!constant_energy_) {
        return;
    }
    if (!at_first_) {
        at_first_ = now.total_energy;
    }
    const double rise = now.total_energy - *at_first_;
    const double allowed = energy_allowance + kinetic_allowance * now.kinetic_energy + pairs_crossing * jump_at_cutoff_;
    if (!(rise <= allowed)) {
        throw PhysicsError(
            fmt::format("the total energy has risen by {:.3g} epsilon per atom in this stage, which should "
                        "conserve it. Is the time step of {:.6g} tau too large?",
                        rise, time_step_));
    }
}

}  // namespace ljmd
