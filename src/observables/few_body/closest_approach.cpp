#include "observables/few_body/closest_approach.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "observables/statistics/hermite.hpp"

namespace ljmd {

std::string unresolved_encounter(const std::string& who, double time, double path) {
    return fmt::format(
        "{} at time {:.6g} within a step, in which they move by {:.2g} times their distance: the motion is wrong from "
        "there on; take smaller steps, or the adaptive method prince-dormand",
        who, time, path);
}

std::string unresolved_encounter(const Approach& approach) {
    return unresolved_encounter(fmt::format("bodies {} and {} meet", approach.first, approach.second), approach.time,
                                approach.path_in_step / approach.distance);
}

void ClosestApproach::add(const State& state) {
    const Index bodies = state.count();
    if (last_ && (!(state.time > last_->time) || last_->r.cols() != bodies)) {
        throw ContractViolation(fmt::format("{} bodies at time {} cannot follow {} bodies at time {}", bodies,
                                            state.time, last_->r.cols(), last_->time));
    }
    Sample now{state.time, Eigen::Matrix3Xd(3, bodies), Eigen::Matrix3Xd(3, bodies)};
    for (Index i = 0; i < bodies; ++i) {
        const Index id = state.ids()[static_cast<std::size_t>(i)];
        now.r.col(id) = state.positions().col(i);
        now.v.col(id) = state.velocities().col(i);
    }
    for (Index i = 0; i < bodies; ++i) {
        for (Index j = i + 1; j < bodies; ++j) {
            compare_within_step(now, i, j);
            const double path = last_ ? (now.v.col(j) - now.v.col(i)).norm() * (now.time - last_->time) : 0.0;
            compare({(now.r.col(j) - now.r.col(i)).norm(), now.time, i + 1, j + 1, path});
        }
    }
    last_ = std::move(now);
}

void ClosestApproach::archive(Archive& a, const State& now) {
    a(last_, closest_, first_unresolved_);
    if (last_ && (!(last_->time <= now.time) || last_->r.cols() != now.count() || last_->v.cols() != now.count())) {
        throw CheckpointError("its closest approach belongs to other bodies or times");
    }
}

void ClosestApproach::compare(const Approach& candidate) {
    if (!closest_ || candidate.distance < closest_->distance) {
        closest_ = candidate;
    }
}

void ClosestApproach::compare_within_step(const Sample& now, Index i, Index j) {
    if (!last_) {
        return;
    }
    const HermiteStep<Vec3> pair{last_->time,
                                 now.time - last_->time,
                                 last_->r.col(j) - last_->r.col(i),
                                 last_->v.col(j) - last_->v.col(i),
                                 now.r.col(j) - now.r.col(i),
                                 now.v.col(j) - now.v.col(i)};
    constexpr double rounding = 1e-12;
    const double before = pair.x0.dot(pair.v0);
    const double smallest = rounding * pair.x0.norm() * pair.v0.norm();
    if (before <= smallest && pair.x1.dot(pair.v1) > rounding * pair.x1.norm() * pair.v1.norm()) {
        const double s =
            before < -smallest ? root_in_step([&](double x) { return pair.value(x).dot(pair.rate(x)); }) : 0.0;
        const Approach found{pair.value(s).norm(), pair.time(s), i + 1, j + 1, pair.length * pair.rate(s).norm()};
        compare(found);
        if (!first_unresolved_ && !found.resolved()) {
            first_unresolved_ = found;
        }
    }
}

}  // namespace ljmd
