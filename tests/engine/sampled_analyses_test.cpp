#include "engine/sampled_analyses.hpp"

#include "catch.hpp"

#include "core/through_archive.hpp"
#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Notes the steps at which it is asked.
struct Noted : Observer {
    explicit Noted(Index every, bool energy) : every_(every), energy_(energy) {}
    [[nodiscard]] bool needs(Index step) const override { return step % every_ == 0; }
    [[nodiscard]] bool needs_energy() const override { return energy_; }
    void sample(const Snapshot& snapshot) override { steps.push_back(snapshot.step()); }
    void interrupt() override { ++interruptions; }
    [[nodiscard]] std::optional<ObservableAverage> average() const override {
        ObservableAverage found = {};
        found.name = "noted";
        return found;
    }

    std::vector<Index> steps;
    int interruptions = 0;

  private:
    Index every_;
    bool energy_;
};

FluidSystem placed(const FluidSpec& spec) {
    return make_fluid(spec, Execution(), [](const std::string&) {});
}

}  // namespace

TEST_CASE("analyses and observers are due at steps of their own, and need energy as they say") {
    FluidSpec spec = small_spec();
    spec.analyses = {analysis("rdf", {{"every", 5}})};
    FluidSystem fluid = placed(spec);
    Noted fast(2, false);
    Noted slow(7, true);
    SampledAnalyses analyses(spec, fluid, {&fast, &slow});
    CHECK(analyses.are_due(2));
    CHECK(analyses.are_due(5));
    CHECK(analyses.are_due(7));
    CHECK_FALSE(analyses.are_due(1));
    CHECK(analyses.want_energy(7));
    CHECK_FALSE(analyses.want_energy(10));
}

TEST_CASE("who is due takes a sample, at the start all do") {
    FluidSpec spec = small_spec();
    spec.analyses = {analysis("rdf", {{"every", 5}})};
    FluidSystem fluid = placed(spec);
    Noted fast(2, false);
    Noted slow(7, false);
    SampledAnalyses analyses(spec, fluid, {&fast, &slow});
    const Evaluation evaluation = fluid.force_field.evaluate(fluid.state, Request::forces_and_energy);
    fluid.state.step = 4;
    analyses.sample(evaluation, true, false);
    CHECK(fast.steps == std::vector<Index>{4});
    CHECK(slow.steps.empty());
    CHECK(fluid.analyses[0]->samples() == 0);
    fluid.state.step = 1;
    analyses.sample(evaluation, true, false);
    CHECK(fast.steps.size() == 1);
    analyses.sample(evaluation, true, true);
    CHECK(fast.steps == std::vector<Index>{4, 1});
    CHECK(slow.steps == std::vector<Index>{1});
    CHECK(fluid.analyses[0]->samples() == 1);
    RunResult result;
    analyses.add_to(result);
    CHECK(result.table("rdf").rows.size() > 10);
    const std::size_t of_analyses = result.averages.size();
    analyses.add_observed_to(result);
    REQUIRE(result.averages.size() == of_analyses + 2);
    CHECK(result.averages.back().own);
}

TEST_CASE(
    "a stage interrupts observers, and makes analyses anew for a box that has changed before their first sample") {
    FluidSpec spec = small_spec();
    spec.analyses = {analysis("rdf")};
    FluidSystem fluid = placed(spec);
    Noted observer(1, false);
    SampledAnalyses analyses(spec, fluid, {&observer});
    const Analysis* made = fluid.analyses[0].get();
    analyses.stage_begins(spec.stages[1]);
    CHECK(observer.interruptions == 1);
    CHECK(fluid.analyses[0].get() == made);
    fluid.state.rescale_to(Box(1.01 * fluid.state.box().edges()));
    analyses.stage_begins(spec.stages[0]);  // is not sampled
    CHECK(fluid.analyses[0].get() == made);
    analyses.stage_begins(spec.stages[1]);
    CHECK(fluid.analyses[0].get() != made);
}

TEST_CASE("an observer is added once, and checkpoints are of as many as there are") {
    const FluidSpec spec = small_spec();
    FluidSystem fluid = placed(spec);
    Noted observer(1, false);
    SampledAnalyses with(spec, fluid, {&observer});
    CHECK_THROWS_AS(with.add(observer), InputError);
    SampledAnalyses without(spec, fluid, {});
    CHECK_THROWS_WITH(test::through_archive(with, without),
                      Catch::Contains("has 1 observers of the program that wrote it, and 0"));
}

TEST_CASE("correlations of an analysis do not go on across the border of two stages") {
    FluidSpec spec = small_spec();
    spec.analyses = {analysis("msd", {{"max_time", 0.08}, {"every", 1}})};  // 20 lags
    const auto rows = [&](bool is_divided) {
        FluidSystem fluid = placed(spec);
        SampledAnalyses analyses(spec, fluid, {});
        for (Index step = 0; step < 30; ++step) {
            if (step == 15 && is_divided) {
                analyses.stage_begins(spec.stages[1]);
            }
            fluid.state.step = step;
            analyses.sample(Evaluation{}, false, false);
        }
        RunResult result;
        analyses.add_to(result);
        return result.tables.empty() ? std::size_t{0} : result.table("msd").rows.size();
    };
    CHECK(rows(false) == 21);
    CHECK(rows(true) == 0);  // no part is as long as its largest lag
}
