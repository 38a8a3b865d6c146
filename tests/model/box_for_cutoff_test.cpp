#include "model/box_for_cutoff.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("an edge that rounding has left below twice the cutoff becomes that long, and no other edge changes") {
    const Box box(Vec3(3.0 - 4e-14, 4.0, 50.0));
    REQUIRE(box.edges()[0] < 3.0);
    const Box lifted = box_for_cutoff(box, 1.5);
    CHECK(lifted.edges()[0] >= 3.0);
    CHECK(lifted.edges()[0] < 3.0 + 1e-13);
    CHECK(lifted.edges().tail<2>() == box.edges().tail<2>());
    CHECK(box_for_cutoff(box, 1.25).edges() == box.edges());
    CHECK(box_for_cutoff(Box(Vec3::Constant(3.0)), 1.5).edges() == Vec3::Constant(3.0));
}

TEST_CASE("a cutoff that is really more than half an edge stays so") {
    const Box box(Vec3::Constant(3.0));
    CHECK(box_for_cutoff(box, 1.5 * (1.0 + 1e-11)).edges() == box.edges());
    CHECK(box_for_cutoff(box, 2.0).edges() == box.edges());
}
