#include "ljmd/integrators/operators.hpp"

#include <algorithm>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

void require_current_forces(const State& state) {
    if (!state.forces_are_current()) {
        throw ContractViolation("this operator needs the forces at the present positions");
    }
}

void kick(State& state, double dt) {
    require_current_forces(state);
    auto v = state.write_velocities();
    const auto f = static_cast<const State&>(state).forces();
    for (Index i = 0; i < state.count(); ++i) {
        v.col(i) += dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
    }
}

void drift(State& state, double dt) {
    auto r = state.write_positions();
    const auto v = static_cast<const State&>(state).velocities();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = state.snapped(r.col(i) + dt * v.col(i));
    }
}

}  // namespace

Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request) {
    const auto evaluates = [](const Operator& op) { return std::holds_alternative<Evaluate>(op); };
    const auto after_last = std::find_if(operators.rbegin(), operators.rend(), evaluates).base();
    Evaluation evaluation;
    for (auto op = operators.begin(); op != operators.end(); ++op) {
        if (const auto* k = std::get_if<Kick>(&*op)) {
            kick(state, k->dt);
        } else if (const auto* d = std::get_if<Drift>(&*op)) {
            drift(state, d->dt);
        } else if (const auto* e = std::get_if<Evaluate>(&*op)) {
            evaluation = force_field.evaluate(
                state, {.energy = request.energy && op + 1 == after_last, .order_independent = e->order_independent});
        } else if (const auto* u = std::get_if<Update>(&*op)) {
            require_current_forces(state);
            u->apply(state);
        } else {
            std::get<Solve>(*op).advance(state, force_field);
        }
    }
    return evaluation;
}

}  // namespace ljmd
