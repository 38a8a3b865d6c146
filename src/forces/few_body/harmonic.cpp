#include "forces/few_body/bodies.hpp"
#include "forces/few_body_force.hpp"

namespace ljmd {

namespace {

class Harmonic : public ForceField {
  public:
    explicit Harmonic(double stiffness) : stiffness_(stiffness) {}

  private:
    Evaluation compute(State& state, Request request) override {
        return sum_over_bodies(state, request, [this](const Body& body) -> FieldTerm {
            return {0.5 * stiffness_ * body.position.squaredNorm(), -stiffness_ * body.position};
        });
    }

    double stiffness_;
};

struct HarmonicOptions : FewBodyForceOptions {
    double stiffness = 0.0;

    void describe(Description& description) override {
        description.required_number("stiffness", stiffness).unit("mass time^-2").above(0.0).meaning("k");
    }
    [[nodiscard]] std::unique_ptr<ForceField> make() const override { return std::make_unique<Harmonic>(stiffness); }
};

}  // namespace

/// Harmonic force: each body on a spring to the origin, f = -k r, U = sum k r^2 / 2. Period 2 pi sqrt(m/k).
FewBodyForceMethod harmonic() {
    return {.name = "harmonic",
            .meaning = "every body on a spring to the origin, f = -k r",
            .min_dimensions = 1,
            .max_dimensions = 3,
            .options = [] { return std::make_unique<HarmonicOptions>(); }};
}

}  // namespace ljmd
