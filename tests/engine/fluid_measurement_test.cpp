#include "engine/fluid_measurement.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Notes what it is given.
struct Noted : RunOutputs {
    void stage_begins(const Stage& stage) override { stages.push_back(stage.name); }
    using RunOutputs::row;
    void row(const ThermoRow& row) override { rows.push_back(row); }
    [[nodiscard]] bool frame_is_due(const State& state) const override { return state.step % 25 == 0; }
    void frame(const State& state, const std::optional<double>& /*angle*/) override { frames.push_back(state.step); }
    void step_done(Index /*step*/) override { ++steps; }
    [[nodiscard]] bool checkpoint_is_due(Index step, bool last_of_stage) override {
        return last_of_stage || step == 33;
    }
    void checkpoint(const State& state, const LoopPosition& /*position*/,
                    const std::function<void(Archive&)>& archive) override {
        checkpoints.push_back(state.step);
        Archive a;
        archive(a);
        bytes = a.bytes().size();
    }

    std::vector<std::string> stages;
    std::vector<ThermoRow> rows;
    std::vector<Index> frames;
    std::vector<Index> checkpoints;
    Index steps = 0;
    std::size_t bytes = 0;
};

}  // namespace

TEST_CASE("outputs get every row, frame and checkpoint of a run that is due") {
    const FluidSpec spec = small_spec();
    FluidSystem fluid = make_fluid(spec, Execution(), [](const std::string&) {});
    Noted outputs;
    FluidMeasurement measurement(spec, fluid, outputs);
    const LoopPosition end = run_stages(spec.stages, fluid.state, fluid.force_field, measurement.party());
    CHECK(outputs.stages == std::vector<std::string>{"equilibrate", "production"});
    CHECK(outputs.frames == std::vector<Index>{0, 25, 50});
    CHECK(outputs.checkpoints == std::vector<Index>{0, 20, 33, 60});
    CHECK(outputs.bytes > 108 * 3 * 8 * 2);
    CHECK(outputs.steps == 60);
    REQUIRE(outputs.rows.size() == 7);
    CHECK(outputs.rows.front().step == 0);
    CHECK(outputs.rows.front().order.value() == Approx(1.0).epsilon(1e-12));
    CHECK_FALSE(outputs.rows[1].conserved_energy);  // under a thermostat that is not canonical
    CHECK(outputs.rows.back().conserved_energy.value() == outputs.rows.back().values.total_energy);

    const RunResult result = measurement.result(end.seconds);
    CHECK(result.stages.size() == 2);
    CHECK(result.stages[0].last_step == 20);
    CHECK(result.observable("temperature").estimate->samples == 4);
    CHECK(result.first.potential_energy == outputs.rows.front().values.potential_energy);
    CHECK(result.last.potential_energy == outputs.rows.back().values.potential_energy);
    CHECK(result.density == Approx(0.8).epsilon(1e-14));
}

TEST_CASE("analyses that do not fit into the box that a barostat has made end the run") {
    FluidSpec spec = small_spec();
    const double half_edge = 0.5 * box_of(spec).shortest_edge();
    spec.stages[0].integrator = integrator("velocity-verlet");
    spec.stages[0].thermostat = thermostat("stochastic-rescaling");
    spec.stages[0].barostat = barostat("stochastic-cell-rescaling", {{"pressure", 50.0}});
    spec.stages[0].steps = 200;
    spec.analyses = {analysis("rdf", {{"radius", half_edge}})};
    REQUIRE(mistakes(spec).empty());
    FluidSystem fluid = make_fluid(spec, Execution(), [](const std::string&) {});
    Noted outputs;
    FluidMeasurement measurement(spec, fluid, outputs);
    CHECK_THROWS_WITH(
        run_stages(spec.stages, fluid.state, fluid.force_field, measurement.party(), std::nullopt, spec.interaction()),
        Catch::Contains("in the box that the barostat has made: analysis rdf"));
}
