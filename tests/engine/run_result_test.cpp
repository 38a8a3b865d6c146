#include "ljmd/engine/run_result.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "model/checksum.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("a stage that begins is noted with its step and the positions") {
    State state(3, Box(Vec3::Constant(5.0)));
    state.step = 17;
    Stage stage = small_spec().stages[1];
    stage.reverse = true;
    const StageResult begun = begun_stage(stage, state, true);
    CHECK(begun.name == "production");
    CHECK(begun.integrator == "velocity-verlet");
    CHECK(begun.first_step == 17);
    CHECK(begun.last_step == 17);
    CHECK(begun.sampled);
    CHECK(begun.thermostatted);
    CHECK(begun.reversed);
    CHECK(begun.checksum_at_start == checksum(state));
    CHECK(begun.checksum_at_end.empty());
}

TEST_CASE("results belong to the stages that have begun, or are refused") {
    const std::vector<Stage> stages = small_spec().stages;
    const State state(3, Box(Vec3::Constant(5.0)));
    const StageResult first = begun_stage(stages[0], state, false);
    const auto at = [](std::size_t stage, bool begun) {
        LoopPosition position;
        position.stage = stage;
        position.begun = begun;
        return position;
    };
    CHECK_NOTHROW(require_stages({first}, stages, at(0, true)));
    CHECK_NOTHROW(require_stages({first}, stages, at(1, false)));
    CHECK_THROWS_AS(require_stages({}, stages, at(0, true)), CheckpointError);
    CHECK_THROWS_AS(require_stages({first, first}, stages, at(1, true)), CheckpointError);
}
