#include "ljmd/engine/snapshot.hpp"

#include "ljmd/core/errors.hpp"

namespace ljmd {

Snapshot::Snapshot(const State& state, const TailCorrection& tail, std::optional<Evaluation> evaluation)
    : state_(state), tail_(tail), evaluation_(std::move(evaluation)) {}

template <class Column>
const Eigen::Matrix3Xd& Snapshot::by_id(std::optional<Eigen::Matrix3Xd>& kept, const Column& column) const {
    if (!kept) {
        kept.emplace(3, state_.count());
        for (Index i = 0; i < state_.count(); ++i) {
            kept->col(state_.ids()[static_cast<std::size_t>(i)]) = column(i);
        }
    }
    return *kept;
}

const Eigen::Matrix3Xd& Snapshot::positions() const {
    return by_id(positions_, [this](Index i) -> Vec3 {
        const Vec3 r = state_.positions().col(i);
        return r - state_.box().crossings(r).cwiseProduct(edges());
    });
}

const Eigen::Matrix3Xd& Snapshot::unwrapped() const {
    return by_id(unwrapped_, [this](Index i) { return state_.unwrapped(i); });
}

const Eigen::Matrix3Xd& Snapshot::velocities() const {
    const auto v = state_.velocities();
    return by_id(velocities_, [&v](Index i) -> Vec3 { return v.col(i); });
}

const Eigen::Matrix3Xd& Snapshot::forces() const {
    const auto f = state_.forces();
    return by_id(forces_, [&f](Index i) -> Vec3 { return f.col(i); });
}

const Thermodynamics& Snapshot::thermodynamics() const {
    if (!evaluation_) {
        throw InputError("the snapshot has no energy: needs_energy() of the observer does not ask for it");
    }
    if (!thermodynamics_) {
        thermodynamics_ = ljmd::thermodynamics(state_, *evaluation_, tail_);
    }
    return *thermodynamics_;
}

}  // namespace ljmd
