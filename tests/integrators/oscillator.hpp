#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "integrators/integrator.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/options/section.hpp"

namespace ljmd::test {

/// Every atom on a spring of its own to the origin: f = -k r. Knows no box, and remembers what it was asked for.
class Oscillator : public ForceField {
  public:
    explicit Oscillator(double stiffness) : stiffness_(stiffness) {}

    [[nodiscard]] const std::vector<Request>& requests() const { return requests_; }

    [[nodiscard]] double frequency(double mass) const { return std::sqrt(stiffness_ / mass); }

  private:
    Evaluation compute(State& state, Request request) override {
        requests_.push_back(request);
        const auto r = static_cast<const State&>(state).positions();
        state.write_forces() = -stiffness_ * r;
        Evaluation evaluation;
        if (request.energy) {
            evaluation.potential_energy = 0.5 * stiffness_ * r.squaredNorm();
        }
        return evaluation;
    }

    double stiffness_;
    std::vector<Request> requests_;
};

/// Two atoms of different masses in an unbounded system, displaced and moving; forces current.
inline State swinging(Oscillator& springs) {
    State state(2);
    state.write_masses() = {1.0, 2.5};
    state.write_positions().col(0) = Vec3(1.0, -0.5, 0.25);
    state.write_positions().col(1) = Vec3(0.0, 2.0, -1.0);
    state.write_velocities().col(0) = Vec3(0.3, 0.0, -1.0);
    state.write_velocities().col(1) = Vec3(-0.7, 0.2, 0.0);
    springs.evaluate(state, Request::forces);
    return state;
}

// Read access also where the state may be written: a write view would end the integrator's phase.
inline ConstVectorView positions(const State& state) {
    return state.positions();
}
inline ConstVectorView velocities(const State& state) {
    return state.velocities();
}
inline ConstVectorView forces(const State& state) {
    return state.forces();
}

/// n steps of a method with some of its options given, `{"start", "euler"}`.
inline void advance(const std::string& name, const std::vector<std::pair<std::string, std::string>>& options, double dt,
                    Index steps, State& state, ForceField& force_field) {
    const IntegratorMethod method = find_integrator(name);
    Table table;
    for (const auto& [key, value] : options) {
        table.push_back({key, {}, Value{value, {}}});
    }
    Diagnostics diagnostics;
    const Section section = validate(table, {}, Schema(name, keys_of(method)), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    const Integrator integrator(choose(method, section), dt);
    for (Index n = 0; n < steps; ++n) {
        integrator.step(state, force_field, Request::forces);
    }
}

}  // namespace ljmd::test
