// The pressure of gases, which is known: under every canonical thermostat, at constant energy, and held by a barostat.
// 32 atoms, so that a mistake of the order 1/N is one of 3 %.
#include <fmt/format.h>

#include <cmath>
#include "catch.hpp"

#include "core/text.hpp"
#include "deck/deck_fixtures.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/potentials/second_virial.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

constexpr Index atoms = 32;

/// A deck whose second stage is sampled.
/// @param baths  thermostat and barostat of that stage
std::string gas_deck(const std::string& potential, double density, double temperature, Index steps,
                     const std::string& baths) {
    const auto stage = [](const std::string& name, Index steps_of_it, const std::string& rest) {
        return fmt::format("[[stage]]\nname = \"{}\"\ntime_step = 0.01\nsteps = {}\n{}\n", name, steps_of_it, rest);
    };
    return fmt::format(
               "[system]\nlattice = {{ type = \"fcc\", cells = 2 }}\ndensity = {}\ntemperature = {}\nseed = 3\n",
               density, temperature) +
           potential + stage("mix", 2000, "thermostat = { type = \"andersen\", time = 0.5 }") +
           stage("production", steps, baths + "\nsample = true");
}

const std::string lennard_jones_gas =
    "[potential]\ntype = \"lennard-jones\"\ncutoff = 2.5\ntruncation = \"force-shifted\"\n";

/// Atoms that hardly feel each other.
const std::string ideal_gas =
    "[potential]\ntype = \"morse\"\nwell_depth = 1e-12\nsteepness = 1.0\nminimum = 1.0\ncutoff = 1.0\n"
    "truncation = \"force-shifted\"\n\n[neighbors]\nskin = 0.1\n";

/// Averages over the sampled stage of a deck.
class Sampled : private StepObserver {
  public:
    Sampled(const std::string& deck_text, Index every) : every_(every) {
        const Deck deck = DeckFolder(deck_text).load();
        FluidSystem simulation = simulation_of(deck);
        state_ = &simulation.state;
        tail_ = simulation.tail;
        run_stages(deck.stages(), simulation.state, simulation.force_field, {*this}, std::nullopt,
                   fluid_spec(deck).interaction());
    }

    enum Quantity { temperature, pressure, volume, density };
    [[nodiscard]] Estimate operator()(Quantity quantity) const { return means_.estimate(quantity); }

    /// p/(rho T) with the mean temperature.
    [[nodiscard]] Estimate compressibility_factor() const {
        const Eigen::VectorXd mean = means_.mean();
        const double z = mean[pressure] / (mean[density] * mean[temperature]);
        return means_.estimate(z, Eigen::Vector4d(-z / mean[temperature], z / mean[pressure], 0.0, -z / mean[density]));
    }

  private:
    [[nodiscard]] bool wants_energy(Index step) const override { return step % every_ == 0; }
    void step_done(const Stage& stage, const Evaluation& evaluation) override {
        if (stage.sample && state_->step % every_ == 0) {
            const Thermodynamics now = thermodynamics(*state_, evaluation, tail_);
            means_.add(Eigen::Vector4d(*now.temperature, *now.pressure, state_->box().volume(), now.density));
        }
    }

    Index every_;
    const State* state_ = nullptr;
    TailCorrection tail_;
    BlockingAccumulator means_{4, Covariance::full};
};

std::vector<std::string> canonical_thermostats() {
    std::vector<std::string> names;
    for (const auto& method : all_thermostats()) {
        if (method.canonical) {
            names.push_back(method.name);
        }
    }
    return names;
}

std::string thermostat_line(const std::string& name) {
    return fmt::format("thermostat = {{ type = \"{}\", time = 0.1 }}\n", name);
}

}  // namespace

TEST_CASE("a gas has the pressure of its second virial coefficient and of the temperature that was asked for",
          "[ensembles]") {
    constexpr double rho = 0.01;
    constexpr double t = 2.0;
    const double expected =
        1.0 + rho * second_virial_coefficient(PairPotential::lennard_jones("force-shifted", {2.5, 0.0}), t);
    REQUIRE(canonical_thermostats().size() == 4);
    for (const std::string& name : canonical_thermostats()) {
        CAPTURE(name);
        const Sampled gas(gas_deck(lennard_jones_gas, rho, t, 200000, thermostat_line(name)), 5);
        const Estimate p = gas(Sampled::pressure);
        CAPTURE(p.mean / (rho * t), p.standard_error / (rho * t), expected, gas(Sampled::temperature).mean);
        CHECK(std::abs(p.mean / (rho * t) - expected) < 0.01);
        CHECK(p.standard_error / (rho * t) < 0.002);
    }
}

TEST_CASE("at constant energy a gas has the pressure of its second virial coefficient and of its temperature",
          "[ensembles]") {
    constexpr double rho = 0.01;
    const Sampled gas(gas_deck(lennard_jones_gas, rho, 2.0, 200000, ""), 5);
    const double t = gas(Sampled::temperature).mean;
    const double expected =
        1.0 + rho * second_virial_coefficient(PairPotential::lennard_jones("force-shifted", {2.5, 0.0}), t);
    const Estimate z = gas.compressibility_factor();
    CAPTURE(z.mean, z.standard_error, expected, t);
    CHECK(std::abs(z.mean - expected) < 0.01);
    CHECK(z.standard_error < 0.002);
}

TEST_CASE("NIST's gas has NIST's compressibility factor, less what is due to N - 1 neighbours", "[ensembles]") {
    // Force-shifted at 2.5, density 0.01, temperature 0.75: Z = 0.9424. Of pairs there are N (N - 1)/2, not N^2/2.
    constexpr double expected = 1.0 + (0.9424 - 1.0) * (atoms - 1) / atoms;
    const Sampled gas(gas_deck(lennard_jones_gas, 0.01, 0.75, 400000, thermostat_line("stochastic-rescaling")), 10);
    const Estimate z = gas.compressibility_factor();
    CAPTURE(z.mean, z.standard_error, expected);
    CHECK(std::abs(z.mean - expected) < 0.01);
    CHECK(z.standard_error < 0.003);
}

TEST_CASE("a barostat makes the isothermal-isobaric ensemble of an ideal gas, with every canonical thermostat",
          "[ensembles]") {
    // V^N exp(-p V/T): <rho> T/p = 1, <V> p/T = N + 1, and the mean of the pressure is the one that is held. To 0.4 %:
    // tests/physics/gases.py.
    constexpr double p = 0.5;
    constexpr double t = 1.3;
    // A single edge has the relative change of the volume, three times the mobility of each of three. It fluctuates by
    // 17 %, and stays longer than two short cutoffs.
    const bool one_edge = GENERATE(false, true);
    const std::string potential = one_edge ? changed(ideal_gas, {{"cutoff = 1.0", "cutoff = 0.5"}}) : ideal_gas;
    const std::string type = one_edge ? "anisotropic-cell-rescaling\", edges = \"z\"" : "stochastic-cell-rescaling\"";
    for (const std::string& name : canonical_thermostats()) {
        if (one_edge && name != "langevin") {
            continue;
        }
        CAPTURE(name, type);
        const Sampled gas(
            gas_deck(potential, p / t, t, 400000,
                     thermostat_line(name) + fmt::format("barostat = {{ type = \"{}, pressure = {}, time = 3.0, "
                                                         "compressibility = {}, every = 1 }}",
                                                         type, p, (one_edge ? 3.0 : 1.0) / p)),
            1);
        const Estimate density = gas(Sampled::density);
        const Estimate volume = gas(Sampled::volume);
        CAPTURE(density.mean * t / p, density.standard_error * t / p, volume.mean * p / t,
                volume.standard_error * p / t);
        CHECK(std::abs(density.mean * t / p - 1.0) < 0.02);
        CHECK(density.standard_error * t / p < 0.01);
        CHECK(std::abs(volume.mean * p / (t * (atoms + 1)) - 1.0) < 0.02);
        CHECK(volume.standard_error * p / (t * (atoms + 1)) < 0.01);
        CHECK(std::abs(gas(Sampled::pressure).mean / p - 1.0) < 0.02);
    }
}
