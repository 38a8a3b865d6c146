#include "engine/mistakes/until_mistakes.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/statistics/run_averages.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A gas whose kinetic energy is drawn anew every few steps: its samples are soon independent.
FluidSpec quick_spec(double error, Index max_steps) {
    FluidSpec spec = small_spec();
    spec.density = 0.05;
    spec.sample_every = 1;
    Stage& production = spec.stages.back();
    production.thermostat = thermostat("langevin", {{"time", 0.01}});
    production.steps = max_steps;
    production.until = {{"temperature", error}};
    return spec;
}

std::string only(const FluidSpec& spec) {
    const std::vector<Mistake> found = until_mistakes(spec.stages);
    REQUIRE(found.size() == 1);
    return in_words(found.front());
}

/// The doubt that errors were not reached; empty if there is none.
std::string doubt_about_errors(const RunResult& result) {
    for (const std::string& doubt : result.doubts) {
        if (doubt.find("errors wanted") != std::string::npos) {
            return doubt;
        }
    }
    return "";
}

}  // namespace

TEST_CASE("every observable that a stage can wait for is an average of a run with an error") {
    RunAverages averages(4, Ensemble::constant_pressure);
    RunAverages canonical(4, Ensemble::canonical);
    averages.add({});
    canonical.add({});
    for (const UntilObservable& observable : until_observables()) {
        const RunAverages& run = observable.name == "density" ? averages : canonical;
        const auto all = run.averages();
        INFO(observable.name);
        const auto found = std::ranges::find(all, observable.name, &ObservableAverage::name);
        REQUIRE(found != all.end());
        CHECK(found->unit == observable.unit);
    }
}

TEST_CASE("errors are waited for in the last stage, sampled, of observables that have some") {
    const FluidSpec good = quick_spec(0.01, 100);
    CHECK(until_mistakes(good.stages).empty());

    FluidSpec spec = good;
    std::swap(spec.stages[0].until, spec.stages[1].until);
    spec.stages[0].sample = true;
    CHECK_THAT(only(spec), Contains("stage 'equilibrate': only the last stage can end when errors are reached"));

    spec = good;
    spec.stages.back().sample = false;
    CHECK_THAT(only(spec), Contains("a stage that ends when errors are reached is sampled"));

    spec = good;
    spec.stages.back().until = {{"presure", 0.1}};
    CHECK_THAT(only(spec), Contains("no error of 'presure' can be reached; known are temperature, potential_energy"));

    spec.stages.back().until = {{"density", 0.1}};
    CHECK_THAT(only(spec), Contains("it is constant without a barostat"));

    spec.stages.back().until = {{"pressure", 0.0}};
    CHECK_THAT(only(spec), Contains("the error of pressure to be reached is 0, it must be above 0"));

    spec.stages.back().until = {{"pressure", 0.1}, {"pressure", 0.2}};
    CHECK_THAT(only(spec), Contains("two errors of pressure"));

    spec = good;
    spec.stages.back().thermostat.reset();
    spec.stages.back().until = {{"total_energy", 0.1}};
    CHECK_THAT(only(spec), Contains("it is constant without a thermostat"));
    CHECK_THROWS_AS(Simulation(spec), InputError);
}

TEST_CASE("a stage ends at a look at which its error is reached, and the results say so") {
    Simulation simulation(quick_spec(0.02, 20'000));
    const RunResult result = simulation.run();
    CHECK(simulation.finished());
    const StageResult& stage = result.stages.back();
    REQUIRE(stage.until);
    CHECK(stage.until->reached);
    CHECK(stage.until->max_steps == 20'000);
    CHECK(stage.last_step == simulation.state().step);
    CHECK(is_look(stage.last_step - stage.first_step));
    const Estimate& found = result.observable("temperature").estimate.value();
    CHECK(found.standard_error <= 0.02);
    CHECK(found.standard_error == stage.until->errors.front().error);
    CHECK(found.independent_samples >= 150.0);
    CHECK(doubt_about_errors(result).empty());

    SECTION("the error is enlarged, other errors are not") {
        FluidSpec fixed = simulation.spec();
        fixed.stages.back().until.clear();
        fixed.stages.back().steps = stage.last_step - stage.first_step;
        const RunResult same = Simulation(fixed).run();
        CHECK(same.observable("temperature").estimate->mean == found.mean);
        CHECK(same.observable("temperature").estimate->standard_error < found.standard_error);
        CHECK(same.observable("pressure").estimate->standard_error ==
              result.observable("pressure").estimate->standard_error);
    }
}

TEST_CASE("a stage that takes all its steps says which errors it has not reached") {
    Simulation simulation(quick_spec(1e-4, 500));
    const RunResult result = simulation.run();
    CHECK(simulation.state().step == 520);
    CHECK_FALSE(result.stages.back().until->reached);
    CHECK_THAT(doubt_about_errors(result), Contains("stage 'production' ended at its max_steps, 500") &&
                                               Contains("temperature") && Contains("(wanted 0.0001)"));
}

TEST_CASE("a run in parts ends at the same step as in one, wherever it was restored") {
    const FluidSpec spec = quick_spec(0.02, 20'000);
    Simulation whole(spec);
    whole.run();
    const Index end = whole.state().step;
    for (const Index stop :
         {Index{20}, Index{20 + 128}, Index{20 + 181}, Index{20 + 182}, Index{20 + 183}, end - 1, end}) {
        if (stop > end) {
            continue;
        }
        INFO("stopped after step " << stop << " of " << end);
        Simulation first(spec);
        first.advance(stop);
        CHECK(first.finished() == (stop == end));
        Simulation second(spec);
        second.restore(first.checkpoint());
        second.run();
        check_same(second, whole);
        CHECK(second.result().stages.back().until->reached);
    }
}
