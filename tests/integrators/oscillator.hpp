#pragma once

#include <cmath>
#include <vector>

#include "ljmd/forces/force_field.hpp"

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
        if (request == Request::forces_and_energy) {
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

}  // namespace ljmd::test
