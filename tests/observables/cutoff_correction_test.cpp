#include "observables/cutoff_correction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "forces/pair_force_field.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

/// A run in the canonical ensemble with a truncation.
SampledRun canonical_run(const State& state, const std::string& truncation, bool tail) {
    SampledRun run = test::run_of(state);
    const PairPotential potential = PairPotential::lennard_jones(truncation, {2.5, 2.0});
    run.interaction = Interaction{potential, tail ? TailCorrection(potential) : TailCorrection()};
    run.held_temperature = 0.8;
    return run;
}

struct EnergyAndVirial {
    double energy;
    double virial;
};

/// By a plain double loop over atoms with the minimum image.
EnergyAndVirial direct_sum(const State& state, const PairPotential& potential, double radius) {
    EnergyAndVirial sum{0.0, 0.0};
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = i + 1; j < state.count(); ++j) {
            const double r =
                state.box().minimum_image(Vec3(state.positions().col(i)) - Vec3(state.positions().col(j))).norm();
            if (r < radius) {
                sum.energy += potential.untruncated(r).u;
                sum.virial += potential.untruncated(r).w * r * r;
            }
        }
    }
    return sum;
}

Evaluation evaluated(State& state, const SampledRun& run) {
    PairForceField force_field(run.interaction->potential, make_pair_search("all-pairs", 0.0), state.execution());
    return force_field.evaluate(state, Request::forces_and_energy);
}

const ObservableAverage& named(const std::vector<ObservableAverage>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &ObservableAverage::name);
    REQUIRE(found != all.end());
    return *found;
}

}  // namespace

TEST_CASE("one configuration has the energy and pressure of the formula up to half the box, with a tail beyond") {
    const auto* truncation = GENERATE("cut", "shifted", "force-shifted", "switched");
    const bool tail = PairPotential::takes_tail(truncation);
    CAPTURE(truncation);
    State state = test::shaken_crystal(4, 0.8, 0.1, 3);
    const SampledRun run = canonical_run(state, truncation, tail);
    const Evaluation evaluation = evaluated(state, run);
    const double radius = 0.5 * state.box().shortest_edge();
    CutoffCorrection analysis(run, radius, Every(1));
    for (int k = 0; k < 8; ++k) {
        analysis.sample(state, evaluation);
    }
    const auto found = analysis.observables();
    const auto atoms = static_cast<double>(state.count());
    const double volume = state.box().volume();
    const double density = atoms / volume;
    const EnergyAndVirial whole = direct_sum(state, run.interaction->potential, radius);
    // 8 pi rho (R^-9/9 - R^-3/3) and its derivative
    const double pi = std::numbers::pi;
    const double beyond_energy = 8.0 * pi * density * (std::pow(radius, -9) / 9 - std::pow(radius, -3) / 3);
    const double beyond_pressure =
        16.0 / 3.0 * pi * density * density * (2.0 / 3.0 * std::pow(radius, -9) - std::pow(radius, -3));
    const double energy = evaluation.potential_energy / atoms + run.interaction->tail.energy(density);
    const double pressure = virial_pressure(state, evaluation, run.interaction->tail);
    CHECK(named(found, "cutoff_energy").estimate->mean + energy ==
          Approx(whole.energy / atoms + beyond_energy).epsilon(1e-11));
    CHECK(named(found, "cutoff_pressure").estimate->mean + pressure ==
          Approx(whole.virial / (3.0 * volume) + beyond_pressure).epsilon(1e-11));
    // a single configuration does not fluctuate
    CHECK(std::abs(named(found, "cutoff_energy_response").estimate->mean) < 1e-9);
}

TEST_CASE("the response is minus the covariance with the energy that was left out, over T") {
    State first = test::shaken_crystal(3, 0.8, 0.08, 3);
    State second = test::shaken_crystal(3, 0.8, 0.15, 4);
    const SampledRun run = canonical_run(first, "cut", true);
    const Evaluation one = evaluated(first, run);
    const Evaluation two = evaluated(second, run);
    const double radius = 0.5 * first.box().shortest_edge();
    CutoffCorrection analysis(run, radius, Every(1));
    for (int k = 0; k < 64; ++k) {
        analysis.sample(k % 2 == 0 ? first : second, k % 2 == 0 ? one : two);
    }
    const auto atoms = static_cast<double>(first.count());
    const double density = atoms / first.box().volume();
    const TailCorrection beyond(run.interaction->potential.formula_beyond(radius));
    const auto full = [&](const State& state) {
        return direct_sum(state, run.interaction->potential, radius).energy / atoms + beyond.energy(density);
    };
    const double more_of_first = full(first) - one.potential_energy / atoms - run.interaction->tail.energy(density);
    const double more_of_second = full(second) - two.potential_energy / atoms - run.interaction->tail.energy(density);
    const double covariance = 0.25 * (full(first) - full(second)) * (more_of_first - more_of_second);
    const auto found = analysis.observables();
    const double response = named(found, "cutoff_energy_response").estimate->mean;
    CHECK(response == Approx(-atoms / 0.8 * covariance).epsilon(1e-9));
    CHECK(named(found, "cutoff_energy").estimate->mean ==
          Approx(0.5 * (more_of_first + more_of_second) + response).epsilon(1e-9));
}

TEST_CASE("outside the canonical ensemble there is no response, and a remark") {
    State state = test::shaken_crystal(3, 0.8, 0.1, 3);
    SampledRun run = canonical_run(state, "cut", true);
    run.ensemble = Ensemble::constant_energy;
    run.held_temperature.reset();
    CutoffCorrection analysis(run, 2.5, Every(5));
    CHECK(analysis.observables().empty());
    analysis.sample(state, evaluated(state, run));
    for (const ObservableAverage& average : analysis.observables()) {
        CHECK_FALSE(average.estimate);
        CHECK_FALSE(average.remark.empty());
    }
    CHECK(analysis.due(10));
    CHECK_FALSE(analysis.due(11));
}
