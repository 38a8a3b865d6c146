#include "ljmd/forces/external_force.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/text.hpp"
#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Put together vectors by id. @param column  of the atom with this index in memory
template <class Column>
void fill_by_id(const State& state, Eigen::Matrix3Xd& vectors, const Column& column) {
    vectors.resize(3, state.count());
    for_each_index(state.execution(), state.count(),
                   [&](Index i) { vectors.col(state.ids()[static_cast<std::size_t>(i)]) = column(i); });
}

void require_finite(const ExternalForce& force, const Eigen::Matrix3Xd& forces) {
    if (forces.allFinite()) {
        return;
    }
    Index id = 0;
    while (forces.col(id).allFinite()) {
        ++id;
    }
    const Vec3 f = forces.col(id);
    throw PhysicsError(fmt::format("the external force '{}' on atom {} is ({:.6g}, {:.6g}, {:.6g}), not finite",
                                   force.name(), id + 1, f[0], f[1], f[2]));
}

/// Whether columns differ by more than the rounding of their computation.
bool differ(const Eigen::Matrix3Xd& forces) {
    constexpr double rounding = 1e-12;
    if (forces.cols() == 0) {
        return false;
    }
    return (forces.colwise() - forces.col(0)).cwiseAbs().maxCoeff() > rounding * forces.cwiseAbs().maxCoeff();
}

}  // namespace

void AtomPositions::look_at(const State& state) {
    state_ = &state;
    positions_known_ = false;
    unwrapped_known_ = false;
}

const Eigen::Matrix3Xd& AtomPositions::positions() const {
    if (!positions_known_) {
        const auto r = state_->positions();
        const Box& box = state_->box();
        fill_by_id(*state_, positions_, [&](Index i) -> Vec3 {
            const Vec3 x = r.col(i);
            if ((x.array() >= 0.0).all() && (x.array() < box.edges().array()).all()) {
                return x;  // as most are: three divisions less
            }
            return x - box.crossings(x).cwiseProduct(box.edges());
        });
        positions_known_ = true;
    }
    return positions_;
}

const Eigen::Matrix3Xd& AtomPositions::unwrapped() const {
    if (!unwrapped_known_) {
        fill_by_id(*state_, unwrapped_, [this](Index i) { return state_->unwrapped(i); });
        unwrapped_known_ = true;
    }
    return unwrapped_;
}

void archive_presence(Archive& a, const ExternalForce* force) {
    const std::string present = force != nullptr ? force->name() : "";
    const bool has_energy = force != nullptr && force->has_energy();
    std::string name = present;
    bool energy = has_energy;
    a(name, energy);
    if (name != present || energy != has_energy) {
        const auto in_words = [](const std::string& what, bool with) {
            return what.empty() ? std::string("none")
                                : fmt::format("'{}' {} an energy", printable(what, 64), with ? "with" : "without");
        };
        throw CheckpointError(
            fmt::format("the external force of the checkpoint is {}, and {} is there: such a run is resumed by the "
                        "program that began it, with the same force",
                        in_words(name, energy), in_words(present, has_energy)));
    }
}

void ExternalForceTerm::add(State& state, Request request, Evaluation& evaluation) {
    atoms_.look_at(state);
    forces_.setZero(3, state.count());
    const ExternalEnergy found = force_->compute(atoms_, request.energy, forces_);
    if (forces_.cols() != state.count()) {
        throw InputError(
            fmt::format("the external force '{}' has changed the shape of the forces: they are of {} atoms",
                        force_->name(), state.count()));
    }
    require_finite(*force_, forces_);
    differs_ = differ(forces_);
    auto f = state.write_forces();
    const std::vector<Index>& ids = state.ids();
    for_each_index(state.execution(), state.count(),
                   [&](Index i) { f.col(i) += forces_.col(ids[static_cast<std::size_t>(i)]); });
    if (!request.energy) {
        return;
    }
    if (force_->has_energy()) {
        if (!std::isfinite(found.energy)) {
            throw PhysicsError(
                fmt::format("the energy of the external force '{}' is {}", force_->name(), found.energy));
        }
        evaluation.external_energy = found.energy;
    }
    if (force_->has_virial()) {
        if (!found.virial.allFinite()) {
            throw PhysicsError(fmt::format("the virial of the external force '{}' is not finite", force_->name()));
        }
        evaluation.virial += found.virial;
    }
}

}  // namespace ljmd
