#include "ljmd/run/spec_deck.hpp"

#include <limits>
#include <numbers>

#include "deck/deck_fixtures.hpp"
#include "engine/engine_fixtures.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "ljmd/core/errors.hpp"
#include "options/placed.hpp"
#include "options/toml_writer.hpp"
#include "potentials/made_potential.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Deck read(const std::string& text) {
    Diagnostics diagnostics;
    auto deck = load_deck_text("deck", text, {}, true, diagnostics);
    INFO(text);
    for (const Diagnostic& entry : diagnostics.entries()) {
        UNSCOPED_INFO(format(entry));
    }
    REQUIRE(deck.has_value());
    return std::move(*deck);
}

FluidSpec with_stage_of(const IntegratorMethod& method) {
    FluidSpec spec = small_spec();
    spec.stages[1].integrator = integrator(method.name);
    return spec;
}

/// The deck of a specification says what the specification says.
void check_told(const FluidSpec& wanted) {
    const FluidSpec found = fluid_spec(read(deck_text(wanted)));
    REQUIRE(found.start.index() == wanted.start.index());
    CHECK(atoms_of(found) == (std::holds_alternative<Configuration>(wanted.start) ? 0 : atoms_of(wanted)));
    if (!std::holds_alternative<Configuration>(wanted.start)) {
        CHECK(found.density == wanted.density);
        CHECK(box_of(found).edges() == box_of(wanted).edges());
    }
    CHECK(found.temperature == wanted.temperature);
    CHECK(found.seed == wanted.seed);
    CHECK(found.potential.formula() == wanted.potential.formula());
    CHECK(found.potential.truncation() == wanted.potential.truncation());
    CHECK(found.potential.parameters() == wanted.potential.parameters());
    CHECK(found.potential(0.97).u == wanted.potential(0.97).u);
    CHECK(found.potential(0.97 * wanted.potential.cutoff().radius).w ==
          wanted.potential(0.97 * wanted.potential.cutoff().radius).w);
    CHECK(found.has_tail() == wanted.has_tail());
    CHECK(found.neighbors == wanted.neighbors);
    CHECK(found.sample_every == wanted.sample_every);
    CHECK(found.stages == resolved_stages(wanted));
    REQUIRE(found.analyses.size() == wanted.analyses.size());
    for (const Choice& analysis : wanted.analyses) {
        CHECK(std::ranges::find(found.analyses, analysis) != found.analyses.end());
    }
    CHECK(found.units.has_value() == wanted.units.has_value());
    if (wanted.units) {
        CHECK(found.units->si(Dimension::time) == wanted.units->si(Dimension::time));
        CHECK(found.units->si(Dimension::pressure) == wanted.units->si(Dimension::pressure));
    }
}

}  // namespace

TEST_CASE("the deck of a specification says what the specification says, to the last bit") {
    check_told(small_spec());
    FluidSpec odd = small_spec();  // no number has a short decimal form
    odd.start = LatticeStart{.lattice = Lattice::simple_cubic, .cells = 6};
    odd.density = std::numbers::pi / 4.0;
    odd.temperature = 1.0 / 3.0;
    odd.seed = 9007199254740993;  // no double
    odd.stages[0].seed = 0;
    odd.stages[1].seed = odd.seed;
    odd.neighbors = {.method = "verlet-list", .skin = 0.1 * std::numbers::e, .every = 7};
    odd.sample_every = 3;
    odd.stages[0].temperature = 2.0 / 3.0;
    odd.stages[1].reverse = true;
    odd.stages[1].time_step = 1e-5 / 3.0;
    odd.units = SubstanceUnits(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
    check_told(odd);
    odd.start = LatticeStart{.cells = 3, .layers = 4, .height = 9.0 + 1.0 / 3.0};
    odd.tail = false;
    check_told(odd);
    FluidSpec random = small_spec();
    random.start = RandomStart{200};
    random.temperature = 0.0;
    random.neighbors.method = "cells";
    check_told(random);
    FluidSpec given = small_spec();
    given.start = Configuration{.edges = Vec3::Constant(5.0),
                                .positions = {Vec3::Zero(), Vec3::Ones()},
                                .velocities = {Vec3::Ones(), -Vec3::Ones()}};
    given.temperature.reset();
    check_told(given);
    given.temperature = 1.0;
    given.keep_velocities = false;
    check_told(given);
    CHECK_FALSE(fluid_spec(read(deck_text(given))).keep_velocities);
}

TEST_CASE("so it is with every potential, truncation and pair search") {
    for (const std::string& truncation : PairPotential::truncation_names()) {
        for (const std::string& formula : PairPotential::formula_names()) {
            CAPTURE(formula, truncation);
            FluidSpec spec = small_spec();
            const double switch_start = truncation == "switched" ? 0.8 * std::numbers::phi : 0.0;
            spec.potential = made_potential(formula, truncation, {1.9, switch_start}, {{"well_depth", 1.0 / 3.0}});
            for (const bool tail : {false, true}) {
                spec.tail = tail && PairPotential::takes_tail(truncation);
                check_told(spec);
            }
        }
    }
    for (const std::string& method : pair_search_names()) {
        FluidSpec spec = small_spec();
        spec.neighbors.method = method;
        check_told(spec);
    }
}

TEST_CASE("what a deck leaves out has the default of a specification") {
    const Deck deck = read(
        "[system]\nlattice = { type = \"fcc\", cells = 5 }\ndensity = 0.8\ntemperature = 1.0\n\n[potential]\ntype = "
        "\"lennard-jones\"\ncutoff = 2.5\ntruncation = \"shifted\"\n\n[[stage]]\nname = \"only\"\ntime_step = "
        "0.004\nsteps = 10\n");
    FluidSpec spec{.start = LatticeStart{.cells = 5},
                   .density = 0.8,
                   .temperature = 1.0,
                   .potential = PairPotential::lennard_jones("shifted", {2.5})};
    spec.stages = {{.name = "only", .time_step = 0.004, .steps = 10}};
    const FluidSpec found = fluid_spec(deck);
    CHECK(found.neighbors == spec.neighbors);
    CHECK(found.stages == resolved_stages(spec));
    CHECK(found.seed == spec.seed);
    CHECK(found.keep_velocities == spec.keep_velocities);
    CHECK(found.has_tail() == spec.has_tail());
    CHECK(found.sample_every == spec.sample_every);
    const RunFiles files;
    CHECK(deck.title == files.title);
    CHECK(deck.checkpoint.every.seconds == files.checkpoint.every.seconds);
    CHECK(deck.checkpoint.keep == files.checkpoint.keep);
    CHECK_FALSE(deck.trajectory.has_value());
    CHECK(toml_value({table_of(Stage(found.stages[0])), {}}) == toml_value({table_of(resolved_stages(spec)[0]), {}}));
}

TEST_CASE("so it is with every plug-in and its options") {
    for (const IntegratorMethod& method : all_integrators()) {
        if (!method.unbounded_only) {
            check_told(with_stage_of(method));
        }
    }
    for (const ThermostatMethod& method : all_thermostats()) {
        FluidSpec spec = small_spec();
        spec.stages[1].thermostat = thermostat(method.name);
        check_told(spec);
    }
    FluidSpec spec = small_spec();
    spec.stages[1].thermostat = thermostat("nose-hoover-chain", {{"time", 1.0 / 3.0}, {"length", 4}});
    spec.stages[1].barostat = barostat("stochastic-cell-rescaling", {{"pressure", 0.1 / 3.0}});
    check_told(spec);
    for (const AnalysisMethod& method : all_analyses()) {
        CAPTURE(method.name);
        FluidSpec analysed = small_spec();
        analysed.stages[1].steps = 4000;
        analysed.analyses = {analysis(method.name)};
        check_told(analysed);
    }
}

TEST_CASE("files, title and precision are told, too") {
    const RunFiles files{.title = "A \"title\"\\ with\ttwo\nlines",
                         .trajectory = TrajectoryOutput{.format = "xyz", .every = 7, .velocities = true},
                         .checkpoint = {.every = {.steps = 13, .seconds = {}}, .keep = 3}};
    const Deck deck = read(deck_text(small_spec(), files, Precision::mixed));
    CHECK(deck.title == files.title);
    CHECK(deck.trajectory->format == "xyz");
    CHECK(deck.trajectory->every == 7);
    CHECK(deck.trajectory->velocities);
    CHECK_FALSE(deck.trajectory->si());
    CHECK(deck.checkpoint.every.steps == 13);
    CHECK(deck.checkpoint.keep == 3);
    CHECK(execution_options(deck).precision == Precision::mixed);
    for (const TrajectoryFormat& format : all_trajectory_formats()) {
        CHECK(
            read(deck_text(small_spec(), {.trajectory = TrajectoryOutput{.format = format.name}})).trajectory->format ==
            format.name);
    }
    const Deck usual = read(deck_text(small_spec()));
    CHECK_FALSE(usual.trajectory);
    CHECK(usual.checkpoint.every.seconds == 300.0);
    CHECK(usual.checkpoint.keep == 2);
    CHECK(execution_options(usual).precision == Precision::double_precision);
}

TEST_CASE("what no deck can tell, and mistakes, are refused") {
    FluidSpec spec = small_spec();
    spec.stages[1].seed = 8;
    CHECK_THROWS_WITH(deck_text(spec), "stage 'production': in a deck all stages have the seed of the start");
    CHECK_THROWS_AS(deck_text(spec), InputError);
    spec = small_spec();
    spec.seed = std::numeric_limits<std::uint64_t>::max();
    CHECK_THROWS_WITH(deck_text(spec), Contains("seed: a deck has one below 2^63"));
    spec = small_spec();
    spec.stages.clear();
    CHECK_THROWS_WITH(deck_text(spec), Contains("at least one is needed"));
    CHECK_THROWS_WITH(deck_text(small_spec(), {.checkpoint = {.every = {}, .keep = 2}}), Contains("one of both"));
    const auto nothing = [](const PairDistance<double>&) { return PairTerm<double>{0.0, 0.0}; };
    spec = small_spec();
    spec.potential = PairPotential::custom("ideal gas", nothing, "cut", {1.0, 0.0});
    CHECK_THROWS_WITH(deck_text(spec), Contains("'ideal gas' is a formula of the program"));
}
