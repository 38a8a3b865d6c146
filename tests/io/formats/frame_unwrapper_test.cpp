#include "io/formats/frame_unwrapper.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("atoms are followed through the walls, both ways, for many boxes") {
    const Vec3 edges(4.0, 5.0, 6.0);
    const auto place = [](int frame) { return Vec3(0.5 + 1.5 * frame, 1.0 - 0.75 * frame, 3.0); };
    FrameUnwrapper unwrapper;
    for (int frame = 0; frame < 40; ++frame) {
        Configuration wrapped;
        wrapped.edges = edges;
        const Vec3 whole = place(frame);
        wrapped.positions = {whole - Vec3((whole.array() / edges.array()).floor() * edges.array()), Vec3(1, 1, 1)};
        unwrapper.unwrap(wrapped);
        CHECK((wrapped.positions[0] - whole).norm() < 1e-12);
        CHECK(wrapped.positions[1] == Vec3(1, 1, 1));
    }
}

TEST_CASE("positions that are unwrapped stay where they are") {
    FrameUnwrapper unwrapper;
    for (int frame = 0; frame < 10; ++frame) {
        Configuration given;
        given.edges = Vec3(4.0, 5.0, 6.0);
        given.positions = {Vec3(100.0 + frame, -7.0 * 5.0 - 2.0 * frame, 0.25)};
        const Vec3 before = given.positions[0];
        unwrapper.unwrap(given);
        CHECK(given.positions[0] == before);
    }
}
