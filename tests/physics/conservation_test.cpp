// What velocity Verlet conserves on a Lennard-Jones liquid, and how well.
#include <cmath>
#include <string>
#include "catch.hpp"

#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

/// Sum of (E(t) - E(0))^2 on the grid t = 0.004, 0.008, ... 0.5.
double squared_energy_error(State state, const std::string& truncation, double dt) {
    auto force_field = test::lennard_jones(truncation);
    const Integrator integrator(find_integrator("velocity-verlet"), dt);
    const auto steps_per_point = static_cast<Index>(std::lround(0.004 / dt));
    const double start =
        force_field.evaluate(state, Request::forces_and_energy).potential_energy + kinetic_energy(state);
    double sum = 0.0;
    for (int k = 0; k < 125; ++k) {
        Evaluation evaluation;
        for (Index n = 0; n < steps_per_point; ++n) {
            evaluation = integrator.step(state, force_field, Request::forces_and_energy);
        }
        sum += std::pow(evaluation.potential_energy + kinetic_energy(state) - start, 2);
    }
    return sum;
}

}  // namespace

TEST_CASE("the energy error of velocity Verlet is of second order") {
    for (const std::string truncation : {"force-shifted", "switched"}) {
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
            const State start = test::liquid(4, seed, truncation);
            squares += Eigen::Vector3d(squared_energy_error(start, truncation, 0.004),
                                       squared_energy_error(start, truncation, 0.002),
                                       squared_energy_error(start, truncation, 0.001));
        }
        const Eigen::Vector3d rms = squares.cwiseSqrt();
        INFO(truncation << ": " << rms.transpose());
        CHECK(std::log2(rms[0] / rms[1]) == Approx(2.0).margin(0.02));
        CHECK(std::log2(rms[1] / rms[2]) == Approx(2.0).margin(0.02));
    }
}

TEST_CASE(
    "the energy of a force-shifted liquid of 256 atoms drifts less than 1e-7 and keeps its momentum over 1e5 steps",
    "[slow]") {
    State state = test::liquid(4, 7);
    auto force_field = test::lennard_jones("force-shifted");
    force_field.evaluate(state, Request::forces);
    const double drift = test::energy_drift(state, force_field, 0.004, 100000);
    CAPTURE(drift, total_momentum(state).norm());
    CHECK(std::abs(drift) < 1e-7);
    CHECK(total_momentum(state).norm() < 1e-10);
    // Hot enough to be a liquid that diffuses: otherwise the run would prove little.
    CHECK(*temperature(state) > 0.5);
}
