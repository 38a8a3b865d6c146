#include "forces/few_body/bodies.hpp"
#include "forces/few_body_force.hpp"

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

struct RadialKeplerOptions : FewBodyForceOptions {
    double gravitational_parameter_of_both = 0.0;
    double angular_momentum = 0.0;

    void describe(Description& description) override {
        description.required_number("gravitational_parameter", gravitational_parameter_of_both)
            .unit("length^3 time^-2")
            .above(0.0)
            .meaning("mu = G (m1 + m2)");
        description.required_number("angular_momentum", angular_momentum)
            .unit("length^2 time^-1")
            .at_least(0.0)
            .meaning("h, for a unit of reduced mass");
    }
    [[nodiscard]] std::optional<ProblemAtStart> check(const State& start) const override {
        for (const Body& body : bodies_of(start)) {
            if (const auto problem = problem_of(body)) {
                return ProblemAtStart{body.id, *problem};
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] std::unique_ptr<ForceField> make() const override {
        return std::make_unique<RadialKepler>(gravitational_parameter_of_both, angular_momentum);
    }
    [[nodiscard]] AngularVelocity angular_velocity(double distance, double distance_rate) const override {
        const double rate = angular_momentum / (distance * distance);
        return {rate, -2.0 * rate * distance_rate / distance};
    }
};

}  // namespace

/// Distance rho > 0 of two bodies that attract each other by gravity, as a problem in one dimension:
///
///     rho'' = h^2 / rho^3 - mu / rho^2,    U = sum over bodies of m (h^2 / (2 rho^2) - mu / rho)
///
/// mu = G (m1 + m2); h is the angular momentum per unit of reduced mass, which is conserved. With the reduced mass as
/// m, the energy is the two bodies' energy of relative motion. Source: Landau and Lifshitz, Mechanics, sections 14 and
/// 15
FewBodyForceMethod radial_kepler() {
    return {.name = "radial-kepler",
            .meaning = "distance of two bodies under gravity, rho'' = h^2/rho^3 - mu/rho^2",
            .min_dimensions = 1,
            .max_dimensions = 1,
            .has_polar_angle = true,
            .options = [] { return std::make_unique<RadialKeplerOptions>(); }};
}

}  // namespace ljmd
