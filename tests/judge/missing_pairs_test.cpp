#include <cmath>
#include "catch.hpp"

#include "judge/right_trajectory.hpp"
#include "judge/summed_pairs.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::StartsWith;

TEST_CASE("pairs that a stale list has lost are found, by their earlier distance or one by one") {
    Fluid fluid = shaken_crystal();
    for (Vec3& v : fluid.velocities) {
        v *= 3.0;
    }
    // One frame in which few pairs have come in since the list was built, and one with more.
    for (const Index late : {20, 60}) {
        JudgedTrajectory trajectory = right_trajectory(fluid, {0, late});
        const std::vector<Vec3> listed = trajectory.frames[0].positions;
        JudgedFrame& frame = trajectory.frames[1];
        const double range = fluid.potential.cutoff().radius;
        const SummedPairs now(frame.positions, fluid.edges, range);
        Index missing = 0;
        for (const SummedPairs::Pair& pair : now.pairs()) {
            const Vec3 apart = listed[pair.i] - listed[pair.j];
            const Vec3 images = (apart.array() / fluid.edges.array()).round();
            if ((apart - images.cwiseProduct(fluid.edges)).norm() > range + 0.05) {
                const Vec3 force = fluid.potential(pair.distance).w * pair.separation;
                frame.forces[pair.i] -= force;
                frame.forces[pair.j] += force;
                ++missing;
            }
        }
        REQUIRE(missing > 0);
        const auto found = said(fluid, trajectory);
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0], StartsWith("stale list: forces are right at step 0") &&
                                 Catch::Contains("those of " + std::to_string(missing) + " pair"));
    }
    // A pair that any list would have had.
    JudgedTrajectory trajectory = right_trajectory(fluid, {0, 10});
    JudgedFrame& frame = trajectory.frames[1];
    const SummedPairs::Pair pair = SummedPairs(frame.positions, fluid.edges, 1.2).pairs().front();
    const Vec3 force = fluid.potential(pair.distance).w * pair.separation;
    frame.forces[pair.i] -= force;
    frame.forces[pair.j] += force;
    CHECK_THAT(said(fluid, trajectory).at(0),
               StartsWith("missing pair: ") && Catch::Contains("those of 1 pair are missing, of the ids"));
    // Forces of other positions altogether.
    frame.forces = trajectory.frames[0].forces;
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("stale state"));
}
