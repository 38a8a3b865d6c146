#include "bodies.hpp"
#include "ljmd/forces/few_body_force.hpp"

namespace ljmd {

namespace {

/// Error message for a distance from the centre that is not positive; nothing if it is.
std::optional<std::string> problem_of(const Body& body) {
    const double rho = body.position.x();
    if (rho > 0.0) {
        return std::nullopt;
    }
    return fmt::format("body {} is at distance {} from the centre; a distance must be > 0", body.id + 1, rho);
}

class RadialKepler : public ForceField {
  public:
    RadialKepler(double gravitational_parameter, double angular_momentum)
        : mu_(gravitational_parameter), h2_(angular_momentum * angular_momentum) {}

  private:
    Evaluation compute(State& state, Request request) override {
        return sum_over_bodies(state, request, [this](const Body& body) -> FieldTerm {
            if (const auto problem = problem_of(body)) {
                throw PhysicsError(*problem);
            }
            const double inverse = 1.0 / body.position.x();
            return {body.mass * inverse * (0.5 * h2_ * inverse - mu_),
                    Vec3(body.mass * inverse * inverse * (h2_ * inverse - mu_), 0.0, 0.0)};
        });
    }

    double mu_;
    double h2_;
};

}  // namespace

/// Distance rho > 0 of two bodies that attract each other by gravity, as a problem in one dimension:
///
///     rho'' = h^2 / rho^3 - mu / rho^2,    U = sum over bodies of m (h^2 / (2 rho^2) - mu / rho)
///
/// mu = G (m1 + m2); h is the angular momentum per unit of reduced mass, which is conserved. With the reduced mass as
/// m, the energy is that of the relative motion of the two bodies. Source: Landau and Lifshitz, Mechanics, sections 14
/// and 15
FewBodyForceMethod radial_kepler() {
    return {
        .name = "radial-kepler",
        .meaning = "distance of two bodies under gravity, rho'' = h^2/rho^3 - mu/rho^2",
        .keys = {Key::number("gravitational_parameter").unit("length^3 time^-2").above(0.0).meaning("mu = G (m1 + m2)"),
                 Key::number("angular_momentum")
                     .unit("length^2 time^-1")
                     .at_least(0.0)
                     .meaning("h, for a unit of reduced mass")},
        .least_dimensions = 1,
        .most_dimensions = 1,
        .check = [](const Section&, const State& start) -> std::optional<ProblemAtStart> {
            for (const Body& body : bodies_of(start)) {
                if (const auto problem = problem_of(body)) {
                    return ProblemAtStart{body.id, *problem};
                }
            }
            return std::nullopt;
        },
        .make = [](const Section& section) -> std::unique_ptr<ForceField> {
            return std::make_unique<RadialKepler>(section.number("gravitational_parameter"),
                                                  section.number("angular_momentum"));
        },
        .angular_velocity = [](const Section& section, double distance, double distance_rate) -> AngularVelocity {
            const double rate = section.number("angular_momentum") / (distance * distance);
            return {rate, -2.0 * rate * distance_rate / distance};
        }};
}

}  // namespace ljmd
