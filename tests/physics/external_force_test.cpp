// Laws of atoms in an external field: order of the energy's error, equipartition, Boltzmann's distribution, a drive.
#include <algorithm>
#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "forces/made_external_force.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/engine/simulation.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

constexpr double temperature_held = 1.2;
constexpr double most_errors = 3.5;  // the same bits everywhere

/// Atoms that do not see each other.
PairPotential ideal() {
    return PairPotential::custom("ideal",
                                 [](const PairDistance<double>&) {
                                     return PairTerm<double>{0.0, 0.0};
                                 },
                                 "cut", {.radius = 0.5, .switch_start = 0.0});
}

FluidSpec free_atoms(std::shared_ptr<ExternalForce> force) {
    FluidSpec spec{.start = LatticeStart{.lattice = Lattice::fcc, .cells = 4},
                   .density = 0.5,
                   .temperature = temperature_held,
                   .seed = 11,
                   .potential = ideal(),
                   .neighbors = {.method = "cells"},
                   .external = std::move(force)};
    spec.stages = {{.name = "settle",
                    .time_step = 0.02,
                    .steps = 500,
                    .temperature = temperature_held,
                    .thermostat = Choice{"langevin"}}};
    spec.stages.push_back(spec.stages.front());
    spec.stages.back().name = "sampled";
    spec.stages.back().steps = 5000;
    spec.stages.back().sample = true;
    return spec;
}

/// Each atom on a spring to the place where it is first seen.
std::shared_ptr<MadeForce> springs(double k) {
    auto sites = std::make_shared<Eigen::Matrix3Xd>();
    return std::make_shared<MadeForce>(
        [k, sites](const AtomPositions& atoms, Eigen::Matrix3Xd& forces) -> ExternalEnergy {
            if (sites->cols() == 0) {
                *sites = atoms.unwrapped();
            }
            const Eigen::Matrix3Xd d = atoms.unwrapped() - *sites;
            forces = -k * d;
            return {0.5 * k * d.squaredNorm()};
        });
}

void check_mean(const Estimate& found, double expected, double narrow) {
    INFO(found.mean << " +- " << found.standard_error << ", expected " << expected);
    CHECK(std::abs(found.mean - expected) < most_errors * found.standard_error);
    CHECK(found.standard_error < narrow);
}

/// Density in slices along x, over the mean one, and moments of the phase.
class Profile : public Observer {
  public:
    static constexpr Index slices = 8;
    [[nodiscard]] bool needs(Index step) const override { return step % 10 == 0; }
    void sample(const Snapshot& snapshot) override {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(slices);
        const double length = snapshot.edges()[0];
        for (Index i = 0; i < snapshot.atoms(); ++i) {
            const double x = snapshot.positions()(0, i) / length;
            row[std::min(slices - 1, static_cast<Index>(x * slices))] += 1.0;
        }
        series.add(row * (static_cast<double>(slices) / static_cast<double>(snapshot.atoms())));
    }
    BlockingAccumulator series{slices, Covariance::diagonal};
};

}  // namespace

TEST_CASE("an ideal gas in a field has Boltzmann's density, and the temperature of its thermostat") {
    constexpr double depth = 1.5;
    Simulation simulation(free_atoms(wave(depth)));
    Profile profile;
    simulation.add(profile);
    const RunResult result = simulation.run();
    check_mean(result.observable("temperature").estimate.value(), temperature_held, 0.008);
    check_mean(result.observable("kinetic_energy").estimate.value(), 1.5 * temperature_held, 0.012);
    const double b = depth / temperature_held;
    const double mean_cosine = -std::cyl_bessel_i(1.0, b) / std::cyl_bessel_i(0.0, b);
    check_mean(result.observable("external_energy").estimate.value(), depth * mean_cosine, 0.015);
    constexpr int points = 2000;
    double smallest = 2.0;
    for (Index slice = 0; slice < Profile::slices; ++slice) {
        double density = 0.0;
        for (int point = 0; point < points; ++point) {
            const double x =
                (static_cast<double>(slice) + (point + 0.5) / points) / static_cast<double>(Profile::slices);
            density += std::exp(-b * std::cos(2.0 * std::numbers::pi * x)) / (points * std::cyl_bessel_i(0.0, b));
        }
        smallest = std::min(smallest, density);
        check_mean(profile.series.estimate(slice), density, 0.03);
    }
    CHECK(smallest < 0.4);
}

TEST_CASE(
    "equipartition of atoms on springs: 3/2 T of potential and of kinetic energy each, the centre of mass included") {
    for (const char* bath : {"langevin", "andersen"}) {
        CAPTURE(bath);
        FluidSpec spec = free_atoms(springs(4.0));
        spec.start = LatticeStart{.lattice = Lattice::fcc, .cells = 2};
        for (Stage& stage : spec.stages) {
            stage.steps *= 6;
            stage.thermostat = Choice{bath};
        }
        const RunResult result = Simulation(spec).run();
        check_mean(result.observable("temperature").estimate.value(), temperature_held, 0.015);
        check_mean(result.observable("kinetic_energy").estimate.value(), 1.5 * temperature_held, 0.02);
        check_mean(result.observable("external_energy").estimate.value(), 1.5 * temperature_held, 0.02);
    }
}

TEST_CASE("a liquid in a field has the temperature of its thermostat, whether or not that would conserve momentum") {
    for (const char* bath : {"langevin", "andersen", "stochastic-rescaling", "nose-hoover-chain"}) {
        CAPTURE(bath);
        FluidSpec spec = free_atoms(wave(2.0));
        spec.start = LatticeStart{.lattice = Lattice::fcc, .cells = 2};  // 32 atoms: 3 of 96 degrees of freedom show
        spec.potential = PairPotential::lennard_jones("force-shifted", {.radius = 1.9, .switch_start = 0.0});
        spec.neighbors = {};
        for (Stage& stage : spec.stages) {
            stage.time_step = 0.004;
            stage.steps *= 12;
            stage.thermostat = Choice{bath};
        }
        const RunResult result = Simulation(spec).run();
        check_mean(result.observable("temperature").estimate.value(), temperature_held, 0.018);
        // The field changes the momentum along x alone; thermostats of single atoms change that along y and z, too.
        const double freedom = find_thermostat(bath).conserves_momentum ? 3.0 - 2.0 / 32.0 : 3.0;
        check_mean(result.observable("kinetic_energy").estimate.value(), 0.5 * freedom * temperature_held, 0.03);
    }
}

TEST_CASE("velocity Verlet conserves the total energy in a field to second order") {
    const auto deviation = [](double dt) {
        FluidSpec spec = free_atoms(wave(3.0));
        spec.potential = PairPotential::lennard_jones("force-shifted", {.radius = 2.0, .switch_start = 0.0});
        spec.stages = {{.name = "only", .time_step = dt, .steps = std::lround(0.8 / dt), .sample = true}};
        spec.sample_every = 1;
        Simulation simulation(spec);
        simulation.run();
        double largest = 0.0;
        for (const ThermoRow& row : simulation.samples()) {
            largest =
                std::max(largest, std::abs(row.values.total_energy - simulation.samples().front().values.total_energy));
        }
        return largest;
    };
    CHECK(deviation(0.004) / deviation(0.002) == Approx(4.0).epsilon(0.1));
    CHECK(deviation(0.002) / deviation(0.001) == Approx(4.0).epsilon(0.05));
}

TEST_CASE("every integrator keeps its order under a force that depends on time") {
    // A force a cos(w t) on all atoms: the centre of mass moves by a (1 - cos(w t))/w^2.
    constexpr double a = 3.0;
    constexpr double w = 5.0;
    for (const IntegratorMethod& method : all_integrators()) {
        if (method.unbounded_only ||
            method.name == "leapfrog-2tau") {  // its kicks are at the beginnings of double steps
            continue;
        }
        CAPTURE(method.name);
        const auto error = [&](double dt) {
            FluidSpec spec = free_atoms(std::make_shared<MadeForce>(
                [](const AtomPositions& atoms, Eigen::Matrix3Xd& forces) -> ExternalEnergy {
                    forces.row(0).setConstant(a * std::cos(w * atoms.time()));
                    return {};
                },
                false));
            spec.start = LatticeStart{.lattice = Lattice::fcc, .cells = 1};
            spec.density = 0.1;
            spec.temperature = 0.0;
            spec.stages = {
                {.name = "only", .integrator = {method.name}, .time_step = dt, .steps = std::lround(1.0 / dt)}};
            Simulation simulation(spec);
            const double before = simulation.state().unwrapped(0)[0];
            simulation.run();
            const double moved = simulation.state().unwrapped(0)[0] - before;
            return std::abs(moved - a * (1.0 - std::cos(w)) / (w * w));
        };
        CHECK(std::log2(error(0.02) / error(0.01)) == Approx(method.order).margin(0.15));
    }
}
