#include "observables/widom_insertion.hpp"

#include <cmath>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "ljmd/potentials/second_virial.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

const Box box(Vec3(6.0, 6.5, 7.0));

SampledRun run_with(Index atoms, bool tail, std::optional<double> held_temperature) {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    return {atoms,
            box,
            0.004,
            1000,
            5,
            held_temperature,
            Interaction{potential, tail ? TailCorrection(potential) : TailCorrection()}};
}

State state_at(Index atoms, Index step, double temperature, const Execution& execution = test::test_execution()) {
    State state = test::random_state(atoms, box, static_cast<std::uint64_t>(step), execution);
    draw_velocities(state, temperature, static_cast<std::uint64_t>(step));
    state.step = step;
    return state;
}

/// Among atoms that lie anywhere, independent of each other, <exp(-psi/T)> = (1 - 2 B2/V)^N.
double expected_logarithm(Index atoms, double temperature) {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    return static_cast<double>(atoms) *
           std::log(1.0 - 2.0 * second_virial_coefficient(potential, temperature) / box.volume());
}

Estimate measured(const SampledRun& run, double temperature, int samples) {
    WidomInsertion widom(run, 50, Every(1));
    CHECK(widom.observables().empty());
    for (int k = 0; k < samples; ++k) {
        widom.sample(state_at(run.atoms, k, temperature), {});
    }
    CHECK(widom.samples() == samples);
    const auto found = widom.observables();
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "excess_chemical_potential");
    return found[0].estimate.value();
}

}  // namespace

TEST_CASE("among independent atoms the chemical potential is that of the second virial coefficient") {
    const Index atoms = GENERATE(3, 20);
    const std::optional<double> held = GENERATE(std::optional<double>(1.6), std::optional<double>());
    const Estimate found = measured(run_with(atoms, false, held), 1.6, 2000);
    CAPTURE(atoms, held.has_value(), found.mean, found.standard_error);
    CHECK(std::abs(found.mean + 1.6 * expected_logarithm(atoms, 1.6)) < 3.0 * found.standard_error);
    CHECK(found.standard_error < 0.02);
}

TEST_CASE("the tail of one atom more is twice its energy") {
    const SampledRun with = run_with(20, true, std::nullopt);
    const SampledRun without = run_with(20, false, std::nullopt);
    const double tail = 2.0 * with.interaction->tail.energy(20.0 / box.volume());
    CHECK(measured(with, 1.6, 100).mean == Approx(measured(without, 1.6, 100).mean + tail).epsilon(1e-12));
}

TEST_CASE("at constant energy the weights are those of the moment's temperature") {
    const SampledRun run = run_with(20, false, std::nullopt);
    WidomInsertion widom(run, 50, Every(1));
    double sum = 0.0;
    double temperatures = 0.0;
    for (Index k = 0; k < 8; ++k) {
        const double t = k % 2 == 0 ? 1.0 : 2.0;
        widom.sample(state_at(20, k, t), {});
        WidomInsertion alone(run_with(20, false, t), 50, Every(1));
        alone.sample(state_at(20, k, t), {});
        sum += std::pow(t, 1.5) * std::exp(-alone.observables()[0].estimate->mean / t) / 8.0;
        temperatures += t / 8.0;
    }
    const double expected = -temperatures * std::log(sum / std::pow(temperatures, 1.5));
    CHECK(widom.observables()[0].estimate->mean == Approx(expected).epsilon(1e-12));
}

TEST_CASE("where no place has room, or nothing moves, there is no chemical potential") {
    WidomInsertion full(run_with(5000, false, 1e-3), 5, Every(1));
    full.sample(state_at(5000, 1, 1.0), {});
    CHECK_FALSE(full.observables()[0].estimate.has_value());
    WidomInsertion cold(run_with(20, false, std::nullopt), 5, Every(1));
    cold.sample(state_at(20, 1, 0.0), {});
    CHECK_FALSE(cold.observables()[0].estimate.has_value());
    CHECK_THAT(cold.observables()[0].remark, Catch::Contains("divided by the temperature"));
    CHECK_FALSE(full.observables()[0].remark.empty());
}

TEST_CASE("where the places that count were not met there is no chemical potential, but a remark") {
    const auto found = [](Index atoms, double energy_of_an_atom) {
        WidomInsertion widom(run_with(atoms, false, 1.6), 20, Every(1));
        Evaluation evaluation;
        evaluation.potential_energy = 0.5 * energy_of_an_atom * static_cast<double>(atoms);
        for (int k = 0; k < 64; ++k) {
            widom.sample(state_at(atoms, k, 1.6), evaluation);
        }
        return widom.observables().at(0);
    };
    // Inserted particles have an energy of -1 by their weights: so may atoms have, but not one that is 1.6 lower.
    CHECK(found(20, -1.0).estimate.has_value());
    CHECK(found(20, -1.0).remark.empty());
    CHECK_FALSE(found(20, -4.0).estimate.has_value());
    CHECK_FALSE(found(20, -4.0).remark.empty());
    // Among 400 atoms that lie anywhere a few places carry the mean.
    CHECK_FALSE(found(400, 0.0).estimate.has_value());
    CHECK_FALSE(found(400, 0.0).remark.empty());
}

TEST_CASE("of a film it is the chemical potential of the whole box, and says so") {
    SampledRun run = run_with(20, false, 1.6);
    const auto found = [&run] {
        WidomInsertion widom(run, 200, Every(1));
        for (int k = 0; k < 64; ++k) {
            widom.sample(state_at(20, k, 1.6), {});
        }
        return widom.observables().at(0);
    };
    const ObservableAverage alone = found();
    run.is_film = true;
    CHECK(alone.remark.empty());
    CHECK(found().estimate.value().mean == alone.estimate.value().mean);
    CHECK_THAT(found().remark, Catch::Contains("of the whole box"));
}

TEST_CASE("threads and the order of atoms in memory do not matter, steps do") {
    const SampledRun run = run_with(200, false, 3.0);
    const auto found = [&run](const State& state) {
        WidomInsertion widom(run, 3000, Every(1));
        widom.sample(state, {});
        return widom.observables()[0].estimate->mean;
    };
    const State state = state_at(200, 7, 1.0);
    const double value = found(state);
    CHECK(found(state_at(200, 7, 1.0, test::with_threads(3))) == value);
    State later = state;
    later.step = 8;
    CHECK(found(later) != value);
}
