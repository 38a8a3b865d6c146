#include "observables/transport/centre_frame.hpp"

#include "catch.hpp"

#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

State two_atoms() {
    State state = test::state_of({{1.0, 1.0, 1.0}, {3.0, 2.0, 1.0}}, Box(Vec3::Constant(4.0)));
    state.write_masses() = {1.0, 3.0};
    state.write_velocities().col(0) = Vec3(4.0, 0.0, 0.0);
    state.write_velocities().col(1) = Vec3(0.0, 0.0, 8.0);
    return state;
}

}  // namespace

TEST_CASE("positions and velocities are relative to the centre of mass, by id and through walls") {
    State state = two_atoms();
    state.set_image(0, Eigen::Vector3i(-1, 0, 0));  // atom 0 is at (-3, 1, 1), the centre of mass at (1.5, 1.75, 1)
    Eigen::Matrix3Xd r(3, 2);
    r << -4.5, 1.5, -0.75, 0.25, 0.0, 0.0;
    Eigen::Matrix3Xd v(3, 2);
    v << 3.0, -1.0, 0.0, 0.0, -6.0, 2.0;
    CHECK(positions_about_centre(state) == r);
    CHECK(velocities_about_centre(state) == v);
    state.reorder({1, 0});
    CHECK(positions_about_centre(state) == r);
    CHECK(velocities_about_centre(state) == v);
}

TEST_CASE("diffusion is taken back by both its names, and nothing else is") {
    std::vector<ObservableAverage> averages{{"diffusion", "D", "", Estimate{}},
                                            {"diffusion_green_kubo", "D_GK", "", Estimate{}},
                                            {"temperature", "T", "", Estimate{}}};
    withdraw_diffusion(averages, "why");
    CHECK_FALSE(averages[0].estimate.has_value());
    CHECK_FALSE(averages[1].estimate.has_value());
    CHECK(averages[0].remark == "why");
    CHECK(averages[2].estimate.has_value());
    CHECK(averages[2].remark.empty());
}
