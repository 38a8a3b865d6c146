#include "observables/configurational_temperature.hpp"

#include "catch.hpp"

#include "forces/pair_force_field.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"
#include "observables/pair_curvature.hpp"
#include "observables/squared_forces.hpp"

using namespace ljmd;

namespace {

State with_forces(std::uint64_t seed, double shaken) {
    State state = test::shaken_crystal(3, 0.8442, shaken, seed);
    PairForceField force_field(test::run_of(state).interaction->potential, make_pair_search("all-pairs", 0.0),
                               state.execution());
    force_field.evaluate(state, Request::forces_and_energy);
    return state;
}

}  // namespace

TEST_CASE("the configurational temperature is the ratio of two means, with the error of the ratio") {
    const State first = with_forces(1, 0.05);
    const State second = with_forces(2, 0.12);
    const SampledRun run = test::run_of(first);
    const auto& potential = run.interaction->potential;
    ConfigurationalTemperature analysis(run, Every(10));
    CHECK(analysis.observables().empty());
    CHECK(analysis.due(20));
    CHECK_FALSE(analysis.due(25));
    for (int k = 0; k < 40; ++k) {
        analysis.sample(k % 3 == 0 ? first : second, {});
    }
    const ObservableAverage found = analysis.observables().at(0);
    CHECK(found.name == "configurational_temperature");
    const double forces = 14.0 * squared_forces_over_mass(first) + 26.0 * squared_forces_over_mass(second);
    const double curvatures =
        14.0 * pair_curvature(first, potential).laplacian + 26.0 * pair_curvature(second, potential).laplacian;
    CHECK(found.estimate->mean == Approx(forces / curvatures).epsilon(1e-12));
    CHECK(found.estimate->standard_error > 0.0);
}

TEST_CASE("a curvature that is not above zero gives no temperature but a remark") {
    // Two atoms beyond the inflection of their potential, where it is concave.
    State state = test::state_of({Vec3(1.0, 1.0, 1.0), Vec3(2.6, 1.0, 1.0)}, Box(Vec3::Constant(6.0)));
    state.write_forces().setConstant(0.1);
    ConfigurationalTemperature analysis(test::run_of(state), Every(1));
    for (int k = 0; k < 10; ++k) {
        analysis.sample(state, {});
    }
    CHECK_FALSE(analysis.observables().at(0).estimate.has_value());
    CHECK_FALSE(analysis.observables().at(0).remark.empty());
}
