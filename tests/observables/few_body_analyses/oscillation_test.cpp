#include <numbers>

#include "observables/few_body_analyses/made_few_body_analysis.hpp"

using namespace ljmd;

namespace {

const test::Numbers springs{{"stiffness", 1.0}};

/// Two bodies; y of the second is 3 sin(2 t).
const State& at(double time, State& state) {
    const auto index = state.index_of();
    state.write_positions().setConstant(0.5);
    state.write_positions()(1, index[1]) = 3.0 * std::sin(2.0 * time);
    state.write_velocities()(1, index[1]) = 6.0 * std::cos(2.0 * time);
    state.time = time;
    return state;
}

}  // namespace

TEST_CASE("the oscillation of one component of one body has period, amplitude and passages") {
    const test::MadeTarget target(2, 2, "harmonic", springs);
    for (const bool reordered : {false, true}) {
        const auto oscillation =
            test::made_few_body_analysis("oscillation", {{"body", 2}, {"component", 2}}, target.target);
        State state = test::bodies_at({Vec3::Zero(), Vec3::Zero()}, {1.0, 1.0});
        if (reordered) {
            state.reorder({1, 0});
        }
        for (int n = 1; n <= 100; ++n) {
            oscillation->sample({at(0.1 * n, state), std::nullopt});
        }
        CHECK(test::finding(*oscillation, "period") == Approx(std::numbers::pi).epsilon(1e-6));
        CHECK(test::finding(*oscillation, "amplitude") == Approx(3.0).epsilon(1e-5));
        const auto table = oscillation->table();
        REQUIRE(table.has_value());
        CHECK(table->name == "oscillation");
        CHECK(table->columns == std::vector<std::string>{"upward", "time"});
        REQUIRE(table->rows.size() == 6);  // pi/2, pi, ... 3 pi; the first goes down
        for (std::size_t k = 0; k < 6; ++k) {
            CHECK(table->rows[k][0] == static_cast<double>(k % 2));
            CHECK(table->rows[k][1] == Approx(0.5 * std::numbers::pi * static_cast<double>(k + 1)).epsilon(1e-5));
        }
    }
}

TEST_CASE("an oscillation is of the first component of the first body unless told otherwise") {
    const test::MadeTarget target(2, 2, "harmonic", springs);
    const auto oscillation = test::made_few_body_analysis("oscillation", {}, target.target);
    State state = test::bodies_at({Vec3(0.7, 9.0, 0.0), Vec3(9.0, 9.0, 0.0)}, {1.0, 1.0});
    oscillation->sample({state, std::nullopt});
    CHECK(test::finding(*oscillation, "amplitude") == 0.7);
    CHECK_FALSE(test::has_finding(*oscillation, "period"));
}

TEST_CASE("oscillations of bodies and components that are not there are mistakes") {
    using Keys = std::vector<std::string>;
    const test::MadeTarget target(2, 2, "harmonic", springs);
    CHECK(test::faults("oscillation", {{"body", 2}, {"component", 2}}, target.target).empty());
    CHECK(test::faults("oscillation", {{"body", 3}}, target.target) == Keys{"body"});
    CHECK(test::faults("oscillation", {{"component", 3}}, target.target) == Keys{"component"});
    CHECK(test::faults("oscillation", {{"body", 3}, {"component", 3}}, target.target) == Keys{"body", "component"});
}
