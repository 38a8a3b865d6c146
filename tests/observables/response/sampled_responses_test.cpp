#include "observables/response/sampled_responses.hpp"

#include "catch.hpp"

#include "forces/pair_force_field.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"

using namespace ljmd;

namespace {

/// A fluid whose potential ends smoothly, with a tail.
SampledRun run_with_tail(const State& state) {
    const PairPotential potential = PairPotential::lennard_jones("switched", {2.2, 1.8});
    SampledRun run = test::run_of(state);
    run.interaction = Interaction{potential, TailCorrection(potential)};
    return run;
}

double virial_pressure_of(State state, const Interaction& interaction, double factor) {
    state.rescale_to(Box(factor * state.box().edges()));
    PairForceField force_field(interaction.potential, make_pair_search("all-pairs", 0.0), state.execution());
    const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    return virial_pressure(state, evaluation, interaction.tail);
}

}  // namespace

TEST_CASE("samples have the energy, the pressure, and how that changes with the volume, tail included") {
    const State first = test::shaken_crystal(3, 0.9, 0.1, 1);
    const SampledRun run = run_with_tail(first);
    SampledResponses analysis(run, Every(5));
    CHECK(analysis.due(10));
    CHECK_FALSE(analysis.due(12));
    CHECK(analysis.observables().empty());
    ResponseFunctions expected(run.atoms, Ensemble::canonical, std::nullopt, true);
    const double h = 1e-5;
    for (std::uint64_t k = 0; k < 300; ++k) {
        State state = test::shaken_crystal(3, 0.9, 0.05 + 0.001 * static_cast<double>(k % 7), k);
        draw_velocities(state, 1.3, k);
        PairForceField force_field(run.interaction->potential, make_pair_search("all-pairs", 0.0), state.execution());
        const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
        analysis.sample(state, evaluation);
        const Thermodynamics values = thermodynamics(state, evaluation, run.interaction->tail);
        const double pressure = virial_pressure(state, evaluation, run.interaction->tail);
        // V times the derivative is a third of that by the logarithm of the edge.
        const double slope = (virial_pressure_of(state, *run.interaction, 1.0 + h) -
                              virial_pressure_of(state, *run.interaction, 1.0 - h)) /
                             (6.0 * h);
        expected.add({*values.temperature, values.potential_energy, pressure, 1.0 / values.density, -slope - pressure});
    }
    CHECK(analysis.samples() == 300);
    const auto found = analysis.observables();
    const auto reference = expected.observables();
    REQUIRE(found.size() == reference.size());
    int known = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        CAPTURE(found[k].name, found[k].remark);
        REQUIRE(found[k].estimate.has_value() == reference[k].estimate.has_value());
        if (found[k].estimate) {
            ++known;
            CHECK(found[k].estimate->mean == Approx(reference[k].estimate->mean).epsilon(1e-6));
            CHECK(found[k].estimate->standard_error == Approx(reference[k].estimate->standard_error).epsilon(1e-4));
        }
    }
    CHECK(known > 0);
}
