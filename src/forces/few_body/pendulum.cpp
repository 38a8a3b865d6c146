#include <cmath>

#include "bodies.hpp"
#include "ljmd/forces/few_body_force.hpp"

namespace ljmd {

namespace {

/// Moment of inertia m l^2, which the state holds as the mass of the body.
double moment_of_inertia(const Section& section, double mass) {
    const double length = section.number("length");
    return mass * length * length;
}

class Pendulum : public ForceField {
  public:
    Pendulum(double gravity, double length) : strength_(gravity / length) {}

  private:
    Evaluation compute(State& state, Request request) override {
        return sum_over_bodies(state, request, [this](const Body& body) -> FieldTerm {
            const double angle = body.position.x();
            const double half_chord = std::sin(0.5 * angle);  // 1 - cos a = 2 sin^2(a/2) without cancellation
            const double moment = body.mass * strength_;      // m l^2 g/l = m g l
            return {2.0 * moment * half_chord * half_chord, Vec3(-moment * std::sin(angle), 0.0, 0.0)};
        });
    }

    double strength_;  // g/l
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
            .keys = {Key::number("gravity").unit("length time^-2").above(0.0).meaning("g"),
                     Key::number("length").unit("length").above(0.0).meaning("l")},
            .least_dimensions = 1,
            .most_dimensions = 1,
            .check = [](const Section&, const State& start) -> std::optional<ProblemAtStart> {
                for (const Body& body : bodies_of(start)) {
                    if (!std::isnormal(body.mass)) {
                        return ProblemAtStart{body.id, fmt::format("body {} has a moment of inertia m l^2 of {}: mass "
                                                                   "and length are out of the range of numbers",
                                                                   body.id + 1, body.mass)};
                    }
                }
                return std::nullopt;
            },
            .make = [](const Section& section) -> std::unique_ptr<ForceField> {
                return std::make_unique<Pendulum>(section.number("gravity"), section.number("length"));
            },
            .inertia = moment_of_inertia};
}

}  // namespace ljmd
