#include "ljmd/engine/configuration_evaluator.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/pair_search.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// Unwrapped positions by id.
Eigen::Matrix3Xd positions_of(const State& state) {
    Eigen::Matrix3Xd r(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        r.col(state.ids()[static_cast<std::size_t>(i)]) = state.unwrapped(i);
    }
    return r;
}

ConfigurationEvaluator evaluator_of(const FluidSpec& spec, const Execution& execution = {}) {
    return {spec.potential, spec.has_tail(), spec.neighbors, execution};
}

}  // namespace

TEST_CASE("a configuration has the bits that it has as the start of a run, in every search and precision") {
    for (const std::string& search : pair_search_names()) {
        for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
            FluidSpec spec = small_spec();
            spec.neighbors.method = search;
            if (precision == Precision::mixed && !spec.neighbors.keeps_list()) {
                continue;
            }
            const Execution execution(ExecutionOptions{.precision = precision});
            Simulation run(spec, execution);
            run.advance(0);
            const EvaluatedConfiguration found =
                evaluator_of(spec, execution).evaluate(positions_of(run.state()), run.state().box().edges());
            CHECK(found.potential_energy == run.thermodynamics().potential_energy);
            CHECK(found.virial.trace() == run.thermodynamics().virial);
            for (Index i = 0; i < run.state().count(); ++i) {
                CHECK(found.forces.col(run.state().ids()[static_cast<std::size_t>(i)]) == run.state().forces().col(i));
            }
        }
    }
}

TEST_CASE("a list that is kept from one configuration to the next misses no pair") {
    FluidSpec spec = small_spec();
    Simulation run(spec);
    ConfigurationEvaluator kept = evaluator_of(spec);
    while (!run.finished()) {
        run.advance(3);
        const Eigen::Matrix3Xd r = positions_of(run.state());
        const Vec3 edges = run.state().box().edges();
        const EvaluatedConfiguration found = kept.evaluate(r, edges);
        const EvaluatedConfiguration fresh = evaluator_of(spec).evaluate(r, edges);
        CHECK((found.forces - fresh.forces).cwiseAbs().maxCoeff() < 1e-11);
        CHECK((found.virial - fresh.virial).cwiseAbs().maxCoeff() < 1e-9);
        CHECK(found.potential_energy == Approx(fresh.potential_energy).epsilon(1e-13));
        CHECK(found.virial_pressure == Approx(fresh.virial_pressure).epsilon(1e-12));
    }
}

TEST_CASE("wrong configurations are refused, and the next one is evaluated") {
    const FluidSpec spec = small_spec();
    Simulation run(spec);
    const Eigen::Matrix3Xd r = positions_of(run.state());
    const Vec3 edges = run.state().box().edges();
    ConfigurationEvaluator evaluator = evaluator_of(spec);
    const Eigen::Matrix3Xd expected = evaluator.evaluate(r, edges).forces;
    Eigen::Matrix3Xd wrong = r;
    wrong(1, 5) = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(evaluator.evaluate(wrong, edges), Contains("atom 5") && Contains("not finite"));
    wrong(1, 5) = 1e9;
    CHECK_THROWS_WITH(evaluator.evaluate(wrong, edges), Contains("million"));
    CHECK_THROWS_WITH(evaluator.evaluate(r, 0.7 * edges), Contains("half the box"));
    CHECK_THROWS_WITH(evaluator.evaluate(r, -edges), Contains("above 0"));
    CHECK_THROWS_AS(evaluator.evaluate(Eigen::Matrix3Xd(3, 0), edges), InputError);
    wrong = r;
    wrong.col(7) = wrong.col(30) + Vec3(edges[0], 0.0, 0.0);  // one image lies on the other atom
    CHECK_THROWS_WITH(evaluator.evaluate(wrong, edges),
                      Contains("atoms 7 and 30, counted from 0, are 0 apart: they overlap"));
    CHECK(evaluator.evaluate(r, edges).forces == expected);
    CHECK_THROWS_AS(ConfigurationEvaluator(spec.potential, true, spec.neighbors, {}), InputError);
}

TEST_CASE("the energies of the atoms are those of the configuration evaluated last, in the order of its positions") {
    const FluidSpec spec = small_spec();
    Simulation run(spec);
    ConfigurationEvaluator evaluator = evaluator_of(spec);
    CHECK_THROWS_AS(evaluator.atom_energies(), InputError);
    Eigen::Matrix3Xd r = positions_of(run.state());
    const Vec3 edges = run.state().box().edges();
    const EvaluatedConfiguration before = evaluator.evaluate(r, edges);
    const std::vector<double> energies = evaluator.atom_energies();
    double sum = 0.0;
    for (const double energy : energies) {
        sum += energy;
    }
    CHECK(sum == Approx(before.potential_energy * static_cast<double>(r.cols())).epsilon(1e-13));
    r.col(0).swap(r.col(1));
    static_cast<void>(evaluator.evaluate(r, edges));
    const std::vector<double> swapped = evaluator.atom_energies();
    CHECK(swapped[0] == Approx(energies[1]).epsilon(1e-12));
    CHECK(swapped[1] == Approx(energies[0]).epsilon(1e-12));
    CHECK(swapped[2] == Approx(energies[2]).epsilon(1e-12));
}
