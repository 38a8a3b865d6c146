#include "integrators/operators.hpp"

#include <algorithm>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "model/time_over_mass.hpp"

namespace ljmd {

namespace {

void require_current_forces(const State& state) {
    if (!state.forces_are_current()) {
        throw ContractViolation("this operator needs the forces at the present positions");
    }
}

void drift(State& state, double dt) {
    state.finish_kick();
    PaddedView r = padded(state.write_positions());
    const ConstPaddedView v = padded(state.velocities());
    const double rounding = state.rounding();
    for_each_index(state.execution(), state.count(),
                   [=](Index i) mutable { r.col(i) = (r.col(i) + dt * v.col(i) + rounding) - rounding; });
}

/// As padded(), whose columns cost this loop a seventh of its instructions more.
using Vector = Eigen::Map<Eigen::Array4d>;
using ConstVector = Eigen::Map<const Eigen::Array4d>;

/// A kick and the drift after it in one pass over the atoms, together with the pending kick of the last step unless
/// velocities have been read since. Same bits as separate passes, half the memory traffic.
void kick_and_drift(State& state, double dt_kick, double dt_drift) {
    require_current_forces(state);
    const double dt_due = state.take_kick();
    double* v = state.write_velocities().data();
    double* r = state.write_positions().data();
    const double* f = static_cast<const State&>(state).forces().data();
    const double* m = state.masses().data();
    const double rounding = state.rounding();
    for_each_range(state.execution(), state.count(), [=](Index first, Index last) {
        TimeOverMass due(dt_due);
        TimeOverMass factor(dt_kick);
        for (Index i = first; i < last; ++i) {
            Eigen::Array4d velocity = Vector(v + vector_stride * i);
            if (dt_due != 0.0) {
                velocity += due(m[i]) * ConstVector(f + vector_stride * i);
            }
            velocity += factor(m[i]) * ConstVector(f + vector_stride * i);
            Vector(v + vector_stride * i) = velocity;
            Vector(r + vector_stride * i) = (Vector(r + vector_stride * i) + dt_drift * velocity + rounding) - rounding;
        }
    });
}

/// Keeps state.time at the time of the positions during a step, and gives it back afterwards.
class TimeOfPositions {
  public:
    explicit TimeOfPositions(State& state) : state_(state), before_(state.time) {}
    ~TimeOfPositions() { state_.time = before_; }
    TimeOfPositions(const TimeOfPositions&) = delete;
    TimeOfPositions& operator=(const TimeOfPositions&) = delete;

    void move(double dt) { state_.time += dt; }

  private:
    State& state_;
    double before_;
};

}  // namespace

Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request,
                 const StateWatch& within) {
    const auto evaluates = [](const Operator& op) { return std::holds_alternative<Evaluate>(op); };
    const auto after_last = std::find_if(operators.rbegin(), operators.rend(), evaluates).base();
    Evaluation evaluation;
    TimeOfPositions time(state);
    for (auto op = operators.begin(); op != operators.end(); ++op) {
        if (const auto* k = std::get_if<Kick>(&*op)) {
            const auto next = op + 1;
            if (const auto* d = next != operators.end() ? std::get_if<Drift>(&*next) : nullptr) {
                kick_and_drift(state, k->dt, d->dt);
                time.move(d->dt);
                ++op;
            } else {
                require_current_forces(state);
                state.kick(k->dt);
            }
        } else if (const auto* d = std::get_if<Drift>(&*op)) {
            drift(state, d->dt);
            time.move(d->dt);
        } else if (const auto* e = std::get_if<Evaluate>(&*op)) {
            evaluation = force_field.evaluate(
                state, {.energy = request.energy && op + 1 == after_last, .order_independent = e->order_independent});
        } else if (const auto* u = std::get_if<Update>(&*op)) {
            require_current_forces(state);
            state.finish_kick();
            u->apply(state);
            time.move(u->moves);
        } else if (const auto* t = std::get_if<Thermalise>(&*op)) {
            t->apply(state);
        } else {
            state.finish_kick();
            std::get<Solve>(*op).advance(state, force_field, within);
        }
    }
    return evaluation;
}

}  // namespace ljmd
