#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include "catch.hpp"

#include "core/kolmogorov_smirnov.hpp"
#include "integrators/oscillator.hpp"
#include "integrators/thermostats/made_thermostat.hpp"

using namespace ljmd;

namespace {

/// One oscillator of frequency 1 along x, under a chain.
class Oscillation {
  public:
    Oscillation(Index length, double dt)
        : thermostat_(test::made_thermostat("nose-hoover-chain", {1.0, dt, 1, 1}, {{"length", length}, {"time", 1.0}})),
          integrator_(find_integrator("velocity-verlet"), dt) {
        state_.write_positions().col(0) = Vec3(1.0, 0.0, 0.0);
        state_.write_velocities().col(0) = Vec3(0.5, 0.0, 0.0);
        state_.bath = thermostat_->beginning();
    }

    void step() {
        thermostat_->before_step(state_);
        integrator_.step(state_, spring_, Request::forces);
        thermostat_->after_step(state_, 1);
    }

    /// The motion turned round: velocities of atoms and chain.
    void reverse() {
        state_.write_velocities() *= -1.0;
        for (std::size_t k = 1; k < state_.bath.size(); k += 2) {
            state_.bath[k] *= -1.0;
        }
    }

    [[nodiscard]] double x() const { return test::positions(state_)(0, 0); }
    [[nodiscard]] double v() const { return test::velocities(state_)(0, 0); }
    [[nodiscard]] double conserved() const { return 0.5 * (x() * x() + v() * v()) - state_.heat(); }

  private:
    test::Oscillator spring_{1.0};
    State state_{1};
    std::unique_ptr<Thermostat> thermostat_;
    Integrator integrator_;
};

double largest_error_of_conserved(double dt) {
    Oscillation oscillation(3, dt);
    const double at_first = oscillation.conserved();
    double largest = 0.0;
    for (int n = 0; n < std::lround(20.0 / dt); ++n) {
        oscillation.step();
        largest = std::max(largest, std::abs(oscillation.conserved() - at_first));
    }
    return largest;
}

/// How far the distribution of x is from the canonical one, see kolmogorov_smirnov.
double distance_from_canonical(Index length) {
    Oscillation oscillation(length, 0.05);
    std::vector<double> x;
    for (int n = 1; n <= 1000000; ++n) {
        oscillation.step();
        if (n % 500 == 0) {
            x.push_back(oscillation.x());
        }
    }
    return test::kolmogorov_smirnov(x, [](double r) { return gsl_cdf_ugaussian_P(r); });
}

}  // namespace

TEST_CASE("the energy of the extended system is conserved to second order") {
    const double coarse = largest_error_of_conserved(0.02);
    const double fine = largest_error_of_conserved(0.01);
    CHECK(coarse < 1e-3);
    CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.1));
}

TEST_CASE("turned round, a chain and its oscillator go back the way they came") {
    Oscillation oscillation(3, 0.01);
    for (int n = 0; n < 1000; ++n) {
        oscillation.step();
    }
    CHECK(std::abs(oscillation.x() - 1.0) > 0.01);
    oscillation.reverse();
    for (int n = 0; n < 1000; ++n) {
        oscillation.step();
    }
    CHECK(std::abs(oscillation.x() - 1.0) < 1e-11);
    CHECK(std::abs(oscillation.v() + 0.5) < 1e-11);
}

TEST_CASE("a chain makes one oscillator canonical, a single thermostat does not") {
    CHECK(distance_from_canonical(3) < 1.63);
    CHECK(distance_from_canonical(1) > 3.0);
}

TEST_CASE("the chain's numbers follow the heat: velocity and position of each thermostat") {
    State state = test::moving_atoms(2.0);
    const auto thermostat =
        test::made_thermostat("nose-hoover-chain", test::bath_of(state, 1.0, 0.001), {{"length", std::int64_t{2}}});
    CHECK(thermostat->beginning().size() == 5);
    state.bath = thermostat->beginning();
    test::act(*thermostat, state, 1);
    // Q_1 dv/dt = 2 K - f T = f T (T_now/T - 1), Q_1 = f T tau_T^2
    CHECK(state.bath[1] == Approx(0.001 * (2.0 - 1.0) / 0.25).epsilon(1e-2));
    CHECK(state.heat() < 0.0);  // the chain has taken it
}
