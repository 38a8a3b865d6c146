#include "analyze/position_reading.hpp"

#include "catch.hpp"

#include <cmath>
#include <random>

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

const Vec3 edges(4.0, 5.0, 6.0);

Vec3 wrapped(const Vec3& r) {
    return r - Vec3((r.array() / edges.array()).floor() * edges.array());
}

/// Atoms that walk at random, each step normal along each axis.
/// @param step  standard deviation, in edges
FrameMotion walk(double step, bool wrap) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, step);
    std::uniform_real_distribution<double> inside(0.0, 1.0);
    std::vector<Vec3> places(50);
    for (Vec3& place : places) {
        place = Vec3(inside(random), inside(random), inside(random)).cwiseProduct(edges);
    }
    FrameMotionMeter meter;
    for (int frame = 0; frame < 60; ++frame) {
        Configuration found;
        found.edges = edges;
        for (Vec3& place : places) {
            found.positions.push_back(wrap ? wrapped(place) : place);
            place += Vec3(normal(random), normal(random), normal(random)).cwiseProduct(edges);
        }
        meter.add(found);
    }
    return meter.motion();
}

}  // namespace

TEST_CASE("the motion from frame to frame is measured in edges, to the nearest image") {
    FrameMotionMeter meter;
    Configuration found;
    found.edges = edges;
    found.positions = {{0.4, 1, 1}, {1, 1, 1}};
    meter.add(found);
    CHECK(meter.motion().largest_step == 0.0);
    found.positions = {{3.8, 1, 1}, {1, 3.25, 1}};
    meter.add(found);
    CHECK(meter.motion().largest_step == Approx(0.45));
    CHECK(meter.motion().jumps == 1);
    CHECK(meter.motion().spread == Approx(0.85));
}

TEST_CASE("wrapped positions are told from unwrapped ones by their displacements") {
    for (const double step : {0.01, 0.04}) {
        CAPTURE(step);
        CHECK(read_positions(walk(step, true), false, {}).positions == Positions::wrapped);
        CHECK(read_positions(walk(step, true), false, {}).doubt.empty());
        CHECK(read_positions(walk(step, false), false, {}).positions == Positions::unwrapped);
    }
}

TEST_CASE("displacements that do not separate tell nothing, unless no atom moves by half an edge") {
    const PositionReading far = read_positions(walk(0.15, true), false, {});
    CHECK_FALSE(far.positions);
    CHECK_THAT(far.reason, Contains("neither the file nor the displacements tell") && Contains("--positions"));
    CHECK_FALSE(read_positions(walk(0.3, false), false, {}).positions);
    CHECK(read_positions(walk(0.08, false), false, {}).positions == Positions::unwrapped);
    CHECK(read_positions(walk(0.3, false), true, {}).positions == Positions::unwrapped);
    CHECK(read_positions(walk(0.3, false), true, {}).told_by == "file");
}

TEST_CASE("what the user says counts, unless positions cannot be followed like that") {
    const PositionReading followed = read_positions({0.3, 5, 1.0}, false, Positions::wrapped);
    CHECK(followed.positions == Positions::wrapped);
    CHECK(followed.told_by == "--positions");
    CHECK_THAT(followed.doubt, Contains("the wrong one"));
    CHECK(read_positions({0.1, 5, 1.0}, false, Positions::wrapped).doubt.empty());
    const PositionReading lost = read_positions({0.48, 5, 1.0}, true, Positions::wrapped);
    CHECK_FALSE(lost.positions);
    CHECK_THAT(lost.reason, Contains("too far to follow"));
    CHECK(read_positions({0.48, 5, 9.0}, false, Positions::unwrapped).doubt.empty());
    CHECK_THAT(read_positions({0.1, 5, 1.0}, false, Positions::unwrapped).doubt, Contains("look wrapped"));
}

TEST_CASE("a file that tells is believed, unless its atoms jump by edges within one box") {
    CHECK(read_positions({0.1, 5, 3.0}, true, {}).positions == Positions::unwrapped);
    const PositionReading contradicted = read_positions({0.1, 5, 1.05}, true, {});
    CHECK(contradicted.positions == Positions::wrapped);
    CHECK_THAT(contradicted.doubt, Contains("the file says that positions are unwrapped"));
    CHECK_FALSE(read_positions({0.1, 5, 3.0}, false, {}).positions);
}

TEST_CASE("what was assumed is said in a line") {
    CHECK(description({Positions::wrapped, "displacements", "", ""}, {0.097, 9, 1.0}) ==
          "positions: wrapped, atoms followed by their nearest images, at most 0.097 edges away (told by "
          "displacements)");
    CHECK(description({Positions::unwrapped, "file", "", ""}, {0.3, 9, 4.0}) ==
          "positions: unwrapped (told by the file)");
    CHECK(description({Positions::unwrapped, "displacements", "", ""}, {0.3, 0, 4.0}) ==
          "positions: unwrapped (no atom moves by more than half an edge between frames)");
    CHECK(description({Positions::unwrapped, "--positions", "", ""}, {0.3, 9, 4.0}) ==
          "positions: unwrapped (told by --positions)");
}
