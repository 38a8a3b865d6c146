#include <cmath>

#include "forces/few_body/bodies.hpp"
#include "forces/few_body_force.hpp"

namespace ljmd {

namespace {

/// Attraction between unit masses at separation d with G = 1.
struct Attraction {
    double depth;         ///< (d^2 + s^2)^(-1/2)
    double inverse_cube;  ///< (d^2 + s^2)^(-3/2)

    Attraction(const Vec3& d, double softening2) {
        const double distance2 = d.squaredNorm() + softening2;
        depth = 1.0 / std::sqrt(distance2);
        inverse_cube = depth / distance2;
    }

    /// False where bodies are too close for the attraction to be a finite number.
    [[nodiscard]] bool is_finite() const { return std::isfinite(inverse_cube); }
};

std::string collision(const Body& one, const Body& other) {
    const Vec3& r = other.position;
    return fmt::format("bodies {} and {} are both at ({}, {}, {}): their attraction has no value without softening",
                       one.id + 1, other.id + 1, r[0], r[1], r[2]);
}

std::string fall(const Body& body) {
    return fmt::format(
        "body {} is at the origin, where the central mass is: its attraction has no value without softening",
        body.id + 1);
}

class NewtonianGravity : public ForceField {
  public:
    NewtonianGravity(double gravitational_constant, double softening, double central_mass)
        : gravitational_constant_(gravitational_constant),
          softening2_(softening * softening),
          central_mass_(central_mass) {}

    [[nodiscard]] std::optional<ProblemAtStart> problem_of(const std::vector<Body>& bodies) const {
        for (const Body& body : bodies) {
            if (central_mass_ > 0.0 && !Attraction(body.position, softening2_).is_finite()) {
                return ProblemAtStart{body.id, fall(body)};
            }
            for (Index other = 0; other < body.id; ++other) {
                const Body& earlier = bodies[static_cast<std::size_t>(other)];
                if (!Attraction(body.position - earlier.position, softening2_).is_finite()) {
                    return ProblemAtStart{body.id, collision(earlier, body)};
                }
            }
        }
        return std::nullopt;
    }

  private:
    /// The force on each body is summed over the others in the order of their ids.
    Evaluation compute(State& state, Request request) override {
        auto f = state.write_forces();
        const std::vector<Body> bodies = finite_bodies_of(state);
        Evaluation evaluation;
        for (const Body& body : bodies) {
            Vec3 force = Vec3::Zero();
            for (const Body& other : bodies) {
                if (other.id != body.id) {
                    force += attract(body, other, evaluation);
                }
            }
            if (central_mass_ > 0.0) {
                force += attract_to_centre(body, evaluation);
            }
            f.col(body.index) = force;
        }
        return asked_for(request, evaluation);
    }

    /// Force on `body`. Each pair is counted once in the evaluation.
    [[nodiscard]] Vec3 attract(const Body& body, const Body& other, Evaluation& evaluation) const {
        const Vec3 d = body.position - other.position;
        const Attraction attraction(d, softening2_);
        if (!attraction.is_finite()) {
            throw PhysicsError(collision(body, other));
        }
        // The product of the masses comes first, so that the forces on the two bodies are opposite to the last bit.
        const double strength = gravitational_constant_ * (body.mass * other.mass);
        const Vec3 force = -strength * attraction.inverse_cube * d;
        if (body.id < other.id) {
            evaluation.potential_energy -= strength * attraction.depth;
            evaluation.virial += d * force.transpose();
        }
        return force;
    }

    [[nodiscard]] Vec3 attract_to_centre(const Body& body, Evaluation& evaluation) const {
        const Attraction attraction(body.position, softening2_);
        if (!attraction.is_finite()) {
            throw PhysicsError(fall(body));
        }
        const double strength = gravitational_constant_ * (central_mass_ * body.mass);
        const Vec3 force = -strength * attraction.inverse_cube * body.position;
        evaluation.potential_energy -= strength * attraction.depth;
        evaluation.virial += body.position * force.transpose();
        return force;
    }

    double gravitational_constant_;
    double softening2_;
    double central_mass_;
};

struct NewtonianGravityOptions : FewBodyForceOptions {
    double gravitational_constant = 0.0;
    double softening = 0.0;
    double central_mass = 0.0;

    void describe(Description& description) override {
        description.required_number("gravitational_constant", gravitational_constant)
            .unit("length^3 mass^-1 time^-2")
            .above(0.0)
            .meaning("G");
        description.number("softening", softening)
            .unit("length")
            .at_least(0.0)
            .meaning("s: distances r count as (r^2 + s^2)^(1/2)");
        description.number("central_mass", central_mass)
            .unit("mass")
            .at_least(0.0)
            .meaning("M, a mass held at the origin beside the bodies");
    }
    [[nodiscard]] std::optional<ProblemAtStart> check(const State& start) const override {
        return NewtonianGravity(gravitational_constant, softening, central_mass).problem_of(bodies_of(start));
    }
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> without_effect(Index bodies) const override {
        if (bodies > 1 || central_mass > 0.0) {
            return {};
        }
        return {{"gravitational_constant",
                 "gravity has no effect on a single body without 'central_mass': it moves straight on"}};
    }
    [[nodiscard]] std::unique_ptr<ForceField> make() const override {
        return std::make_unique<NewtonianGravity>(gravitational_constant, softening, central_mass);
    }
    [[nodiscard]] std::optional<double> gravitational_parameter(double mass,
                                                                std::optional<double> other_mass) const override {
        if (softening > 0.0) {
            return std::nullopt;  // no inverse square
        }
        return gravitational_constant * (other_mass ? mass + *other_mass : central_mass);
    }
};

}  // namespace

/// Newtonian gravity between bodies, with optional softening s and an optional mass M held at the origin:
///
///     a_i = -G sum over j of m_j d_ij / (d_ij^2 + s^2)^(3/2) - G M r_i / (r_i^2 + s^2)^(3/2),    d_ij = r_i - r_j
///     U   = -sum over pairs of G m_i m_j / (d_ij^2 + s^2)^(1/2) - sum over i of G M m_i / (r_i^2 + s^2)^(1/2)
///
/// Two bodies move relative to each other as one body does about M = m1 + m2. Sources: Plummer (1911),
/// doi:10.1093/mnras/71.5.460, for the softening; Aarseth (1963), doi:10.1093/mnras/126.3.223, for its use here
FewBodyForceMethod newtonian_gravity() {
    return {.name = "newtonian-gravity",
            .meaning = "gravity between all bodies, and towards a mass held at the origin",
            .min_dimensions = 1,
            .max_dimensions = 3,
            .attracts = true,
            .options = [] { return std::make_unique<NewtonianGravityOptions>(); }};
}

}  // namespace ljmd
