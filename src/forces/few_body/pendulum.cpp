#include <cmath>

#include "forces/few_body/bodies.hpp"
#include "forces/few_body_force.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

class Pendulum : public ForceField {
  public:
    Pendulum(double gravity, double length) : strength_(gravity / length) {}

  private:
    Evaluation compute(State& state, Request request) override {
        return sum_over_bodies(state, request, [this](const Body& body) -> FieldTerm {
            const double angle = body.position.x();
            const double half_chord = sine(0.5 * angle);  // 1 - cos a = 2 sin^2(a/2) without cancellation
            const double moment = body.mass * strength_;  // m l^2 g/l = m g l
            return {2.0 * moment * half_chord * half_chord, Vec3(-moment * sine(angle), 0.0, 0.0)};
        });
    }

    double strength_;  // g/l
};

struct PendulumOptions : FewBodyForceOptions {
    double gravity = 0.0;
    double length = 0.0;

    void describe(Description& description) override {
        description.required_number("gravity", gravity).unit("length time^-2").above(0.0).meaning("g");
        description.required_number("length", length).unit("length").above(0.0).meaning("l");
    }
    [[nodiscard]] std::optional<ProblemAtStart> check(const State& start) const override {
        for (const Body& body : bodies_of(start)) {
            if (!std::isnormal(body.mass)) {
                return ProblemAtStart{body.id, fmt::format("body {} has a moment of inertia m l^2 of {}: mass and "
                                                           "length are out of the range of numbers",
                                                           body.id + 1, body.mass)};
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] std::unique_ptr<ForceField> make() const override {
        return std::make_unique<Pendulum>(gravity, length);
    }
    /// m l^2; the state holds it as the mass of the body.
    [[nodiscard]] double inertia(double mass) const override { return mass * length * length; }
};

}  // namespace

/// Plane pendulum without friction. The coordinate is the angle theta from the lowest point, in radians:
///
///     theta'' = -(g/l) sin theta,    U = sum over bodies of m g l (1 - cos theta),    K = sum of m l^2 theta'^2 / 2
///
/// The momentum is p = m l^2 theta', the force is the torque -m g l sin theta. Period of a swing of amplitude a: 4
/// sqrt(l/g) K(sin(a/2)), with K the complete elliptic integral of the first kind. Source: Landau and Lifshitz,
/// Mechanics, section 11, problem 1
FewBodyForceMethod pendulum() {
    return {.name = "pendulum",
            .meaning = "plane pendulum, the coordinate is its angle in radians, theta'' = -(g/l) sin theta",
            .min_dimensions = 1,
            .max_dimensions = 1,
            .options = [] { return std::make_unique<PendulumOptions>(); }};
}

}  // namespace ljmd
