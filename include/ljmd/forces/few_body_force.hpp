#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/section.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// Why the forces have no value at the start.
struct ProblemAtStart {
    Index body;           ///< id of the body at fault; of two bodies the later one
    std::string message;  ///< one line; names bodies, counted from 1
};

/// How fast a polar angle turns.
struct AngularVelocity {
    double rate;   ///< [rad/time]
    double slope;  ///< of the rate, [rad/time^2]
};

/// A kind of force on a few bodies in unbounded space that decks can select. One file in src/forces/few_body each.
///
/// Bodies live in the first 1, 2 or 3 components of space; the others are 0. All numbers are in the deck's own
/// units. The virial of such a system is W_ab = sum over bodies of r_a f_b, r from the origin.
///
/// Every force field made here is evaluated in the order of the bodies' ids, whatever their order in memory, and throws
/// PhysicsError naming the bodies, counted from 1, when a position is not finite or when bodies have collided.
struct FewBodyForceMethod {
    std::string name;
    std::string meaning;
    std::vector<Key> keys;  ///< beside `type`
    int least_dimensions;   ///< of space
    int most_dimensions;
    /// What makes this start impossible; nothing when it is possible. @pre positions are finite
    std::function<std::optional<ProblemAtStart>(const Section&, const State& start)> check;
    std::function<std::unique_ptr<ForceField>(const Section&)> make;
    /// mu of the inverse-square attraction mu/r^2 that a body of this mass feels towards another or, without another,
    /// towards the origin: what orbital elements are made from. Empty for forces that have none.
    std::function<std::optional<double>(const Section&, double mass, std::optional<double> other_mass)>
        gravitational_parameter = {};
    /// Rate of the polar angle that goes with a coordinate that is a distance. Empty where there is none.
    std::function<AngularVelocity(const Section&, double distance, double distance_rate)> angular_velocity = {};
    /// What stands for the mass of a body whose coordinate q is not a length: the state holds it in place of the mass,
    /// and K = inertia (dq/dt)^2 / 2, p = inertia dq/dt, d2q/dt2 = f/inertia. Empty: the mass itself.
    std::function<double(const Section&, double mass)> inertia = {};
};

/// Every few-body force there is, in alphabetical order.
[[nodiscard]] std::vector<FewBodyForceMethod> all_few_body_forces();

/// @throws InputError for an unknown name
[[nodiscard]] FewBodyForceMethod find_few_body_force(const std::string& name);

}  // namespace ljmd
