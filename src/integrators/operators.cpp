#include "ljmd/integrators/operators.hpp"

#include <algorithm>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/threads.hpp"

namespace ljmd {

namespace {

void require_current_forces(const State& state) {
    if (!state.forces_are_current()) {
        throw ContractViolation("this operator needs the forces at the present positions");
    }
}

/// Four numbers an atom: the fourth of positions, velocities and forces is zero and stays so (see VectorView).
using Atom = Eigen::Map<Eigen::Array4d>;
using ConstAtom = Eigen::Map<const Eigen::Array4d>;

/// dt/m of one atom after the other, divided only where the mass changes: with nearly all atoms of one mass, divisions
/// were a fifth of the time of kicks and drifts.
class TimeOverMass {
  public:
    explicit TimeOverMass(double dt) : dt_(dt), quotient_(dt) {}
    double operator()(double mass) {
        if (mass != mass_) {
            mass_ = mass;
            quotient_ = dt_ / mass;
        }
        return quotient_;
    }

  private:
    double dt_;
    double mass_ = 1.0;
    double quotient_;
};

void kick(State& state, double dt) {
    require_current_forces(state);
    double* v = state.write_velocities().data();
    const double* f = static_cast<const State&>(state).forces().data();
    const double* m = state.masses().data();
    for_each_block(state.count(), loop_block, [=](Index first, Index last) {
        TimeOverMass factor(dt);
        for (Index i = first; i < last; ++i) {
            Atom(v + 4 * i) += factor(m[i]) * ConstAtom(f + 4 * i);
        }
    });
}

void drift(State& state, double dt) {
    double* r = state.write_positions().data();
    const double* v = static_cast<const State&>(state).velocities().data();
    const double rounding = state.rounding();
    for_each_index(state.count(), [=](Index i) {
        Atom(r + 4 * i) = (Atom(r + 4 * i) + dt * ConstAtom(v + 4 * i) + rounding) - rounding;
    });
}

/// A kick and the drift that follows it in one pass over the atoms: the same bits, and half the traffic of memory.
void kick_and_drift(State& state, double dt_kick, double dt_drift) {
    require_current_forces(state);
    double* v = state.write_velocities().data();
    double* r = state.write_positions().data();
    const double* f = static_cast<const State&>(state).forces().data();
    const double* m = state.masses().data();
    const double rounding = state.rounding();
    for_each_block(state.count(), loop_block, [=](Index first, Index last) {
        TimeOverMass factor(dt_kick);
        for (Index i = first; i < last; ++i) {
            const Eigen::Array4d velocity = ConstAtom(v + 4 * i) + factor(m[i]) * ConstAtom(f + 4 * i);
            Atom(v + 4 * i) = velocity;
            Atom(r + 4 * i) = (Atom(r + 4 * i) + dt_drift * velocity + rounding) - rounding;
        }
    });
}

}  // namespace

Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request) {
    const auto evaluates = [](const Operator& op) { return std::holds_alternative<Evaluate>(op); };
    const auto after_last = std::find_if(operators.rbegin(), operators.rend(), evaluates).base();
    Evaluation evaluation;
    for (auto op = operators.begin(); op != operators.end(); ++op) {
        if (const auto* k = std::get_if<Kick>(&*op)) {
            const auto next = op + 1;
            if (const auto* d = next != operators.end() ? std::get_if<Drift>(&*next) : nullptr) {
                kick_and_drift(state, k->dt, d->dt);
                ++op;
            } else {
                kick(state, k->dt);
            }
        } else if (const auto* d = std::get_if<Drift>(&*op)) {
            drift(state, d->dt);
        } else if (const auto* e = std::get_if<Evaluate>(&*op)) {
            evaluation = force_field.evaluate(
                state, {.energy = request.energy && op + 1 == after_last, .order_independent = e->order_independent});
        } else if (const auto* u = std::get_if<Update>(&*op)) {
            require_current_forces(state);
            u->apply(state);
        } else if (const auto* t = std::get_if<Thermalise>(&*op)) {
            t->apply(state);
        } else {
            std::get<Solve>(*op).advance(state, force_field);
        }
    }
    return evaluation;
}

}  // namespace ljmd
