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

/// A start at which the forces have no value.
struct ProblemAtStart {
    Index body;           ///< id of the body at fault; for a pair the later one
    std::string message;  ///< one line; names bodies, counted from 1
};

/// Angular velocity of a polar angle and its time derivative.
struct AngularVelocity {
    double rate;   ///< [rad/time]
    double slope;  ///< derivative of the rate [rad/time^2]
};

/// A force on a few bodies in unbounded space, as decks select it. Each is one file in src/forces/few_body.
///
/// Bodies live in the first 1, 2 or 3 components of space; the others are 0. All numbers are in the deck's own units.
/// The virial is W_ab = sum over bodies of r_a f_b, with r from the origin.
///
/// Force fields made here evaluate bodies in the order of their ids, whatever their order in memory. They throw
/// PhysicsError, which names bodies counted from 1, when a position is not finite or when bodies have collided.
struct FewBodyForceMethod {
    std::string name;
    std::string meaning;
    std::vector<Key> keys;  ///< options besides `type`
    int least_dimensions;   ///< smallest dimension of space
    int most_dimensions;    ///< largest dimension of space
    /// Why this start is impossible; nothing if it is possible. @pre positions are finite
    std::function<std::optional<ProblemAtStart>(const Section&, const State& start)> check;
    std::function<std::unique_ptr<ForceField>(const Section&)> make;
    /// mu of the inverse-square attraction mu/r^2 between a body of this mass and another one or, without another, the
    /// origin. Orbital elements are computed from it. Empty for forces of another kind; no value if the options change
    /// the law.
    std::function<std::optional<double>(const Section&, double mass, std::optional<double> other_mass)>
        gravitational_parameter = {};
    /// Angular velocity that belongs to a coordinate which is a distance. Empty for forces without a polar angle.
    std::function<AngularVelocity(const Section&, double distance, double distance_rate)> angular_velocity = {};
    /// Generalised mass of a body whose coordinate q is not a length: K = inertia (dq/dt)^2 / 2, p = inertia dq/dt,
    /// d2q/dt2 = f/inertia. The state holds it as the mass. Empty: the mass itself.
    std::function<double(const Section&, double mass)> inertia = {};
};

/// All few-body forces, in alphabetical order.
[[nodiscard]] std::vector<FewBodyForceMethod> all_few_body_forces();

/// @throws InputError for an unknown name
[[nodiscard]] FewBodyForceMethod find_few_body_force(const std::string& name);

}  // namespace ljmd
