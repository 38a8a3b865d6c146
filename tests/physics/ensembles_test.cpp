// What thermostats sample: the canonical ensemble, as far as kinetic and potential energies can tell.

#include <gsl/gsl_cdf.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <memory>
#include "catch.hpp"

#include "core/kolmogorov_smirnov.hpp"
#include "integrators/oscillator.hpp"
#include "integrators/thermostats/made_thermostat.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

/// A system that moves under a thermostat.
template <class Force>
class Bathed {
  public:
    Bathed(State start, Force force, std::unique_ptr<Thermostat> thermostat, double dt)
        : state_(std::move(start)),
          force_(std::move(force)),
          thermostat_(std::move(thermostat)),
          integrator_(Integrator(find_integrator("velocity-verlet"), dt).with_mid_drift([this](State& state) {
              thermostat_->mid_drift(state);
              half_way_kinetic_energy_ = ljmd::kinetic_energy(state);
          })) {
        state_.bath = thermostat_->beginning();
    }
    Bathed(const Bathed&) = delete;
    Bathed& operator=(const Bathed&) = delete;

    void run(Index steps) {
        for (Index n = 0; n < steps; ++n) {
            thermostat_->before_step(state_);
            const bool last = n + 1 == steps;
            const Evaluation evaluation =
                integrator_.step(state_, force_, last ? Request::forces_and_energy : Request::forces);
            potential_energy_ = evaluation.potential_energy;
            thermostat_->after_step(state_, ++state_.step);
        }
    }

    [[nodiscard]] const State& state() const { return state_; }
    [[nodiscard]] double potential_energy() const { return potential_energy_; }
    [[nodiscard]] double kinetic_energy() const { return ljmd::kinetic_energy(state_); }
    [[nodiscard]] double conserved_energy() const { return potential_energy_ + kinetic_energy() - state_.heat(); }

    /// Of velocities half-way of the drift, which thermostats that act there make right.
    [[nodiscard]] double sound_kinetic_energy() const {
        return thermostat_->acts_mid_drift() ? half_way_kinetic_energy_ : kinetic_energy();
    }

  private:
    State state_;
    Force force_;
    std::unique_ptr<Thermostat> thermostat_;
    Integrator integrator_;
    double potential_energy_ = 0.0;
    double half_way_kinetic_energy_ = 0.0;
};

/// 32 soft spheres (Weeks, Chandler and Andersen) under a thermostat, melted.
class SoftSpheres : public Bathed<PairForceField> {
  public:
    static constexpr double dt = 0.004;

    SoftSpheres(double temperature, std::unique_ptr<Thermostat> thermostat)
        : Bathed(start(temperature),
                 {PairPotential::lennard_jones("shifted", {std::pow(2.0, 1.0 / 6.0), 0.0}),
                  make_pair_search("all-pairs", 0.0)},
                 std::move(thermostat), dt) {
        run(5000);
    }

  private:
    static State start(double temperature) {
        State state = test::crystal(2, 0.7);
        draw_velocities(state, temperature, 17);
        return state;
    }
};

constexpr Index spheres = 32;
constexpr Index steps_between_samples = 100;  // four relaxation times of the thermostats here
constexpr int samples = 2000;
constexpr int kinetic_samples = 4000;  // three degrees of freedom are then 5.5 +- 0.5 off, by Kolmogorov and Smirnov

/// @param method  a canonical one
std::unique_ptr<Thermostat> fast(const ThermostatMethod& method, double temperature) {
    return test::made_thermostat(method.name, {temperature, SoftSpheres::dt, 23, degrees_of_freedom(spheres)},
                                 {{"time", 0.1}});
}

/// How far the kinetic energies under a thermostat are from Gamma(f/2) of temperature T.
double distance_of_kinetic_energies(std::unique_ptr<Thermostat> thermostat, double temperature, Index freedom) {
    SoftSpheres fluid(temperature, std::move(thermostat));
    std::vector<double> reduced;
    for (int n = 0; n < kinetic_samples; ++n) {
        fluid.run(steps_between_samples);
        reduced.push_back(fluid.sound_kinetic_energy() / temperature);
    }
    return test::kolmogorov_smirnov(
        reduced, [&](double k) { return gsl_cdf_gamma_P(k, 0.5 * static_cast<double>(freedom), 1.0); });
}

std::vector<double> potential_energies(const ThermostatMethod& method, double temperature) {
    SoftSpheres fluid(temperature, fast(method, temperature));
    std::vector<double> energies;
    for (int n = 0; n < samples; ++n) {
        fluid.run(steps_between_samples);
        energies.push_back(fluid.potential_energy());
    }
    return energies;
}

struct Slope {
    double value;
    double standard_error;
};

/// Slope b of ln(P_1(U)/P_2(U)) = a + b U, by maximum likelihood from equally many samples of each.
/// Source: Shirts (2013), doi:10.1021/ct300688p
Slope slope_of_log_ratio(const std::vector<double>& first, const std::vector<double>& second) {
    double centre = 0.0;
    for (std::size_t k = 0; k < first.size(); ++k) {
        centre += (first[k] + second[k]) / static_cast<double>(2 * first.size());
    }
    Eigen::Vector2d parameters = Eigen::Vector2d::Zero();
    Eigen::Matrix2d information;
    for (int iteration = 0; iteration < 50; ++iteration) {
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        information.setZero();
        const auto add = [&](double energy, double is_first) {
            const Eigen::Vector2d x(1.0, energy - centre);
            const double p = 1.0 / (1.0 + std::exp(-parameters.dot(x)));
            gradient += (is_first - p) * x;
            information += p * (1.0 - p) * x * x.transpose();
        };
        for (std::size_t k = 0; k < first.size(); ++k) {
            add(first[k], 1.0);
            add(second[k], 0.0);
        }
        parameters += information.inverse() * gradient;
    }
    return {parameters[1], std::sqrt(information.inverse()(1, 1))};
}

/// Berendsen's weak coupling, which draws the temperature towards its mean without noise.
class WeakCoupling : public Thermostat {
  public:
    void after_step(State& state, Index /*step_of_stage*/) const override {
        const double factor = std::sqrt(1.0 + SoftSpheres::dt / 0.1 * (1.0 / *temperature(state) - 1.0));
        state.write_velocities() *= factor;
    }
};

}  // namespace

TEST_CASE("under canonical thermostats the kinetic energy has the canonical distribution", "[ensembles][long]") {
    for (const auto& method : all_thermostats()) {
        if (!method.canonical) {
            continue;
        }
        CAPTURE(method.name);
        const Index freedom = method.conserves_momentum ? 3 * spheres - 3 : 3 * spheres;
        CHECK(distance_of_kinetic_energies(fast(method, 1.0), 1.0, freedom) < test::one_in_a_million);
        // The test can tell: three degrees of freedom more or less are too many.
        const Index other = method.conserves_momentum ? 3 * spheres : 3 * spheres - 3;
        CHECK(distance_of_kinetic_energies(fast(method, 1.0), 1.0, other) > test::one_in_a_million);
    }
}

TEST_CASE("a rescaling without noise gives a kinetic energy that hardly fluctuates, and is found out", "[ensembles]") {
    CHECK(distance_of_kinetic_energies(std::make_unique<WeakCoupling>(), 1.0, 3 * spheres - 3) > 5.0);
}

TEST_CASE("energies at two temperatures are in the ratio of their Boltzmann factors", "[ensembles]") {
    for (const auto& method : all_thermostats()) {
        if (!method.canonical) {
            continue;
        }
        CAPTURE(method.name);
        const Slope slope = slope_of_log_ratio(potential_energies(method, 1.0), potential_energies(method, 1.2));
        CAPTURE(slope.value, slope.standard_error);
        CHECK(std::abs(slope.value - (1.0 / 1.2 - 1.0)) < 5.0 * slope.standard_error);
        CHECK(slope.standard_error < 0.1 * (1.0 - 1.0 / 1.2));
    }
}

TEST_CASE("thermostats that keep the motion conserve energy and heat together", "[ensembles]") {
    for (const char* name : {"nose-hoover-chain", "stochastic-rescaling"}) {
        CAPTURE(name);
        const State start = test::liquid(4, 3);
        Bathed<PairForceField> fluid(start, test::lennard_jones("force-shifted"),
                                     test::made_thermostat(name, test::bath_of(start, 0.75, 0.004)), 0.004);
        LinearTrend energy;
        double max_heat = 0.0;  // it comes and goes
        for (int n = 0; n < 2000; ++n) {
            fluid.run(10);
            energy.add(0.04 * n, fluid.conserved_energy() / static_cast<double>(start.count()));
            max_heat = std::max(max_heat, std::abs(fluid.state().heat()));
        }
        CHECK(std::abs(energy.slope().value()) < 2e-6);
        CHECK(max_heat > 1.0);
    }
}

TEST_CASE("Langevin's oscillators are right in position, and half-way in velocity, and known at whole steps",
          "[ensembles]") {
    // For omega dt = 0.5: <x^2> = T/k and <v^2> = (T/m)(1 - (omega dt)^2/4) at whole steps.
    State start(200, std::nullopt, test::test_execution());
    draw_velocities(start, 1.0, 3);
    Bathed<test::Oscillator> oscillators(start, test::Oscillator(1.0),
                                         test::made_thermostat("langevin", {1.0, 0.5, 5, 600}, {{"time", 1.0}}), 0.5);
    oscillators.run(200);
    double x2 = 0.0;
    double v2 = 0.0;
    double mid_drift = 0.0;
    constexpr int rounds = 10000;
    for (int n = 0; n < rounds; ++n) {
        oscillators.run(1);
        x2 += oscillators.state().positions().squaredNorm() / (600.0 * rounds);
        v2 += 2.0 * oscillators.kinetic_energy() / (600.0 * rounds);
        mid_drift += 2.0 * oscillators.sound_kinetic_energy() / (600.0 * rounds);
    }
    // 6e6 numbers, each remembered for a few steps: the means are known to 0.002.
    CHECK(x2 == Approx(1.0).margin(0.008));
    CHECK(mid_drift == Approx(1.0).margin(0.008));
    CHECK(v2 == Approx(1.0 - 0.25 / 4.0).margin(0.008));
}
