#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/options/choice.hpp"

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

/// Options of a force on a few bodies in unbounded space (see Description), and what follows from them.
///
/// Bodies live in the first 1, 2 or 3 components of space; the others are 0. All numbers are in the deck's own units.
/// The virial is W_ab = sum over bodies of r_a f_b, with r from the origin.
class FewBodyForceOptions {
  public:
    virtual ~FewBodyForceOptions() = default;
    virtual void describe(Description& description) = 0;

    /// Why this start is impossible; nothing if it is possible. @pre positions are finite
    [[nodiscard]] virtual std::optional<ProblemAtStart> check(const State& /*start*/) const { return std::nullopt; }

    /// Which options do nothing for so many bodies, as pairs of key and message.
    [[nodiscard]] virtual std::vector<std::pair<std::string, std::string>> without_effect(Index /*bodies*/) const {
        return {};
    }

    /// The force field. It evaluates bodies in the order of their ids, whatever their order in memory, and throws
    /// PhysicsError, which names bodies counted from 1, when a position is not finite or when bodies have collided.
    [[nodiscard]] virtual std::unique_ptr<ForceField> make() const = 0;

    /// mu of the inverse-square attraction mu/r^2 between a body of this mass and another one or, without another, the
    /// origin. Orbital elements are computed from it. Nothing for forces of another kind.
    [[nodiscard]] virtual std::optional<double> gravitational_parameter(double /*mass*/,
                                                                        std::optional<double> /*other_mass*/) const {
        return std::nullopt;
    }

    /// Angular velocity that belongs to a coordinate which is a distance.
    /// @pre FewBodyForceMethod::has_polar_angle
    [[nodiscard]] virtual AngularVelocity angular_velocity(double distance, double distance_rate) const;

    /// Generalised mass of a body whose coordinate q is not a length: K = inertia (dq/dt)^2 / 2, p = inertia dq/dt,
    /// d2q/dt2 = f/inertia. The state holds it as the mass.
    [[nodiscard]] virtual double inertia(double mass) const { return mass; }

  protected:
    FewBodyForceOptions() = default;
    FewBodyForceOptions(const FewBodyForceOptions&) = default;
    FewBodyForceOptions& operator=(const FewBodyForceOptions&) = default;
};

/// A force on a few bodies, as decks select it. Each is one file in src/forces/few_body.
struct FewBodyForceMethod {
    std::string name;
    std::string meaning;
    int min_dimensions;            ///< smallest dimension of space
    int max_dimensions;            ///< largest dimension of space
    bool attracts = false;         ///< bodies have a gravitational_parameter(), unless the options soften it
    bool has_polar_angle = false;  ///< the coordinate is a distance, with an angular_velocity()
    std::function<std::unique_ptr<FewBodyForceOptions>()> options;  ///< at their defaults
};

using ChosenFewBodyForce = Chosen<FewBodyForceMethod, FewBodyForceOptions>;

/// All few-body forces, in alphabetical order.
[[nodiscard]] std::vector<FewBodyForceMethod> all_few_body_forces();

/// @throws InputError for an unknown name
[[nodiscard]] FewBodyForceMethod find_few_body_force(const std::string& name);

/// The force of a choice with its options. @throws InputError see chosen()
[[nodiscard]] ChosenFewBodyForce chosen_few_body_force(const Choice& choice);

}  // namespace ljmd
