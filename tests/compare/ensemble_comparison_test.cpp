#include "compare/ensemble_comparison.hpp"

#include <cmath>
#include <random>
#include "catch.hpp"

#include "compare/made_peer.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

EnsembleOptions options_for(const Fluid& fluid) {
    return {.integrator = "velocity-verlet",
            .time_step = 0.004,
            .steps = 400,
            .every = 2,
            .frame_every = 20,
            .bins = 50,
            .radius = 0.5 * fluid.edges.minCoeff()};
}

EnsembleAverages averages(double mean, double error) {
    EnsembleAverages result;
    result.estimates.fill({mean, error, 100.0, 1000, true});
    return result;
}

}  // namespace

TEST_CASE("averages of ljmd are those of the steps that it samples") {
    const Fluid fluid = warm_crystal();
    const EnsembleOptions options = options_for(fluid);
    const EnsembleAverages found = our_averages(fluid, *MadePeer::force_field_of(fluid), options);
    CHECK(found.frames == 20);
    CHECK(found.rdf.rows.size() == 50);
    CHECK(found.estimates[0].samples == 200);

    State state = state_of(fluid);
    auto force_field = MadePeer::force_field_of(fluid);
    double t = 0.0;
    double u = 0.0;
    for (int n = 0; n < 200; ++n) {
        advance(state, *force_field, 0.004, 2);
        t += temperature(state).value() / 200.0;
        u += force_field->evaluate(state, Request::forces_and_energy).potential_energy / 200.0 / 108.0;
    }
    CHECK(found.estimates[0].mean == Approx(t).epsilon(1e-9));
    CHECK(found.estimates[1].mean == Approx(u).epsilon(1e-9));
}

TEST_CASE("averages of a peer are those of its totals, with one degree of freedom of each axis gone") {
    const Fluid fluid = warm_crystal();
    MadePeer peer(fluid);
    peer.totals = [](Index step) { return Totals{-500.0 + (step % 4 == 0 ? 1.0 : -1.0), 90.0, 30.0}; };
    const EnsembleAverages found = their_averages(fluid, peer, options_for(fluid));
    CHECK(found.estimates[0].mean == Approx(2.0 * 90.0 / (3.0 * 108.0 - 3.0)));
    CHECK(found.estimates[1].mean == Approx(-500.0 / 108.0));
    CHECK(found.estimates[2].mean == Approx((2.0 * 90.0 + 30.0) / (3.0 * fluid.edges.prod())));
    CHECK(found.frames == 20);
}

TEST_CASE("means are compared in standard errors of their difference") {
    const EnsembleComparison comparison = compare_ensembles(averages(1.0, 0.03), averages(1.1, 0.04));
    REQUIRE(comparison.rows.size() == 3);
    CHECK(comparison.rows[0].name == "temperature");
    CHECK(comparison.rows[0].sigmas() == Approx(2.0));
    const Fluid fluid = warm_crystal();
    for (const Check& check : checks_of(comparison, fluid)) {
        CHECK(check.passed());
    }
    for (const Check& check : checks_of(compare_ensembles(averages(1.0, 0.03), averages(1.2, 0.04)), fluid)) {
        CHECK_FALSE(check.passed());
    }
    CHECK(compare_ensembles(averages(1.0, 0.0), averages(1.0, 0.0)).rows[0].sigmas() == 0.0);
    // Two constants that differ are infinitely many errors apart.
    CHECK(compare_ensembles(averages(1.0, 0.0), averages(1.1, 0.0)).rows[0].sigmas() > 1e9);
    CHECK_FALSE(checks_of(compare_ensembles(averages(1.0, NAN), averages(1.1, 0.0)), fluid)[0].passed());
}

TEST_CASE("a single atom has no temperature that could be compared") {
    EnsembleAverages one = averages(1.0, 0.1);
    one.has_temperature = false;
    const EnsembleComparison found = compare_ensembles(one, one);
    REQUIRE(found.rows.size() == 2);
    CHECK(found.rows[0].name == "potential_energy");
}

TEST_CASE("g(r) is compared bin by bin, and few configurations may differ by more") {
    const Fluid fluid = warm_crystal();
    EnsembleAverages a = averages(1.0, 1.0);
    EnsembleAverages b = a;
    a.frames = b.frames = 2400;  // of 108 atoms: as much as 300 of 864
    a.rdf.rows = {{0.5, 0.0, 0.0, 0.0}, {1.0, 2.5, 0.1, 1.0}, {1.5, 1.0, 0.1, 2.0}};
    b.rdf.rows = {{0.5, 0.0, 0.0, 0.0}, {1.0, 2.4, 0.1, 1.0}, {1.5, 1.05, 0.1, 2.0}};
    EnsembleComparison comparison = compare_ensembles(a, b);
    CHECK(comparison.frames == 2400);
    CHECK(comparison.largest_rdf_difference() == Approx(0.1));
    CHECK(comparison.rdf[1].theirs == 2.4);
    REQUIRE(checks_of(comparison, fluid).size() == 4);
    CHECK(checks_of(comparison, fluid)[3].tolerance == Approx(0.08));
    CHECK_FALSE(checks_of(comparison, fluid)[3].passed());
    comparison.frames = 600;
    CHECK(checks_of(comparison, fluid)[3].tolerance == Approx(0.16));
    CHECK(checks_of(comparison, fluid)[3].passed());
    comparison.frames = 0;
    CHECK(checks_of(comparison, fluid).size() == 3);
}
