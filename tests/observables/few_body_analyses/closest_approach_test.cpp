#include "observables/few_body_analyses/made_few_body_analysis.hpp"

using namespace ljmd;

namespace {

const test::Numbers gravity{{"gravitational_constant", 1.0}};

}  // namespace

TEST_CASE("the closest approach says how near, when and which, between samples too") {
    const test::MadeTarget target(3, 2, "newtonian-gravity", gravity);
    const auto closest = test::made_few_body_analysis("closest_approach", {}, target.target);
    CHECK(closest->findings().empty());
    CHECK_FALSE(closest->table().has_value());
    State state = test::bodies_at({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {1.0, 1.0, 1.0});
    for (int n = 0; n <= 4; ++n) {  // the third passes the second at a distance of 0.25 at t = 2.25
        state.time = n;
        state.write_positions().col(0) = Vec3(50.0, 0.0, 0.0);
        state.write_positions().col(1) = Vec3(0.0, 0.25, 0.0);
        state.write_positions().col(2) = Vec3(state.time - 2.25, 0.0, 0.0);
        state.write_velocities().col(2) = Vec3(1.0, 0.0, 0.0);
        closest->sample({state, std::nullopt});
    }
    CHECK(test::finding(*closest, "distance") == Approx(0.25).epsilon(1e-12));
    CHECK(test::finding(*closest, "time") == Approx(2.25).epsilon(1e-12));
    CHECK(test::finding(*closest, "first_body") == 2.0);
    CHECK(test::finding(*closest, "second_body") == 3.0);
}

TEST_CASE("one body alone approaches nobody, which is a mistake") {
    const test::MadeTarget one(1, 2, "newtonian-gravity", gravity);
    const test::MadeTarget two(2, 2, "newtonian-gravity", gravity);
    CHECK(test::faults("closest_approach", {}, one.target) == std::vector<std::string>{""});
    CHECK(test::faults("closest_approach", {}, two.target).empty());
}
