#include "observables/few_body_analyses/made_few_body_analysis.hpp"

using namespace ljmd;

namespace {

const test::Numbers gravity{{"gravitational_constant", 1.0}};

/// An analysis that has seen the third of three bodies pass the second one at a distance of 0.25 at t = 2.25, with
/// speed 1.
std::unique_ptr<FewBodyAnalysis> after_encounter(const test::MadeTarget& target, double step) {
    auto closest = test::made_few_body_analysis("closest_approach", {}, target.target);
    CHECK(closest->findings().empty());
    CHECK_FALSE(closest->table().has_value());
    State state = test::bodies_at({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {1.0, 1.0, 1.0});
    for (int n = 0; n * step < 4.0; ++n) {
        state.time = n * step;
        state.write_positions().col(0) = Vec3(50.0, 0.0, 0.0);
        state.write_positions().col(1) = Vec3(0.0, 0.25, 0.0);
        state.write_positions().col(2) = Vec3(state.time - 2.25, 0.0, 0.0);
        state.write_velocities().col(2) = Vec3(1.0, 0.0, 0.0);
        closest->sample({state, std::nullopt});
    }
    return closest;
}

}  // namespace

TEST_CASE("the closest approach says how near, when and which, between samples too") {
    const test::MadeTarget attracted(3, 2, "newtonian-gravity", gravity);
    const test::MadeTarget springs(3, 2, "harmonic", {{"stiffness", 1.0}});
    for (const auto& closest : {after_encounter(attracted, 0.1), after_encounter(springs, 1.0)}) {
        CHECK(test::finding(*closest, "distance") == Approx(0.25).epsilon(1e-12));
        CHECK(test::finding(*closest, "time") == Approx(2.25).epsilon(1e-12));
        CHECK(test::finding(*closest, "first_body") == 2.0);
        CHECK(test::finding(*closest, "second_body") == 3.0);
    }
}

TEST_CASE("bodies that attract each other have no closest approach where steps do not resolve an encounter") {
    const test::MadeTarget attracted(3, 2, "newtonian-gravity", gravity);
    const auto findings = after_encounter(attracted, 1.0)->findings();
    REQUIRE(findings.size() == 4);
    for (const Finding& finding : findings) {
        CHECK(std::isnan(finding.value));
        CHECK_THAT(finding.remark,
                   Catch::Contains("bodies 2 and 3 meet at time 2.25 within a step, in which they move by "
                                   "4 times their distance"));
    }
}

TEST_CASE("one body alone approaches nobody, which is a mistake") {
    const test::MadeTarget one(1, 2, "newtonian-gravity", gravity);
    const test::MadeTarget two(2, 2, "newtonian-gravity", gravity);
    CHECK(test::faults("closest_approach", {}, one.target) == std::vector<std::string>{""});
    CHECK(test::faults("closest_approach", {}, two.target).empty());
}
