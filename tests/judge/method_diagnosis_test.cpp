#include <array>
#include "catch.hpp"

#include "judge/right_trajectory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// The frames of an engine that moves by r += v dt + c a dt^2, v += (b a + b' a') dt.
JudgedTrajectory moved_by(const Fluid& fluid, const std::vector<Index>& steps, double c, double b, double next_b) {
    JudgedTrajectory trajectory{fluid.edges, dt, {}};
    const auto field = MadePeer::force_field_of(fluid);
    std::vector<Vec3> r = fluid.positions;
    std::vector<Vec3> v = fluid.velocities;
    std::vector<Vec3> a = forces_at(fluid, r, *field, {});
    Index done = 0;
    for (const Index step : steps) {
        for (; done < step; ++done) {
            r = moved(moved(r, dt, v), c * dt * dt, a);
            v = moved(v, b * dt, a);
            a = forces_at(fluid, r, *field, {});
            v = moved(v, next_b * dt, a);
        }
        trajectory.frames.push_back({.step = step, .positions = r, .velocities = v, .forces = a});
    }
    return trajectory;
}

}  // namespace

TEST_CASE("wrong methods are told by where they take the atoms, and nothing else is said of them") {
    struct Wrong {
        std::array<double, 3> factors;
        const char* words;
    };
    const Fluid fluid = shaken_crystal();
    for (const Wrong& wrong : {Wrong{{0.0, 1.0, 0.0}, "explicit Euler"},
                               {{0.5, 0.5, 0.0}, "second half kick: it is missing"},
                               {{0.5, 0.5, 1.0}, "second half kick: it is a whole one"},
                               {{0.0, 0.0, 0.5}, "first half kick: it is missing"},
                               {{1.0, 1.0, 0.5}, "first half kick: it is a whole one"},
                               {{1.0, 0.5, 0.5}, "half of a dt^2: the atoms move by r += v dt + a dt^2,"},
                               {{0.0, 0.5, 0.5}, "half of a dt^2: the atoms move by r += v dt alone"},
                               {{0.5, 1.0, 0.0}, "old forces"},
                               {{0.5, 0.0, 1.0}, "new forces"},
                               {{0.5, 1.0, 1.0}, "both kicks"},
                               {{1.0, 1.0, 0.0}, "half-step start: at step 1 the atoms are a(0) dt^2/2 too far"},
                               {{0.0, 0.0, 1.0}, "half-step start: at step 1 the atoms are a(0) dt^2/2 too near"}}) {
        const auto [c, b, next_b] = wrong.factors;
        for (const std::vector<Index>& steps : {std::vector<Index>{0, 1, 10}, std::vector<Index>{0, 10, 50}}) {
            const auto words = said(fluid, moved_by(fluid, steps, c, b, next_b));
            REQUIRE(words.size() == 1);
            CHECK_THAT(words[0], StartsWith(wrong.words));
        }
    }
    CHECK(said(fluid, moved_by(fluid, {0, 1, 10}, 0.5, 0.5, 0.5)).empty());
    for (const std::string& words : said(fluid, moved_by(fluid, {0, 1, 10}, 0.5, 0.4, 0.5))) {
        CHECK_THAT(words, !Contains("kick") && !Contains("half-step"));  // a method that nobody knows
    }
}

TEST_CASE("velocities that are not those of the start are told from a wrong method by the motion") {
    const Fluid fluid = shaken_crystal();
    Fluid other = fluid;
    for (std::size_t i = 0; i < other.velocities.size(); ++i) {
        other.velocities[i] = fluid.velocities[(i + 1) % fluid.velocities.size()] + Vec3(0.1, 0.0, 0.0);
    }
    JudgedTrajectory trajectory = moved_by(other, {0, 1, 10}, 0.5, 0.5, 0.5);
    CHECK_THAT(said(fluid, trajectory).at(0), StartsWith("other velocities at the start"));
    // a motion that is not theirs either is neither named so, nor called one of another method
    trajectory = moved_by(fluid, {0, 1, 10}, 0.5, 0.4, 0.5);
    trajectory.frames[0].velocities = other.velocities;
    for (const std::string& words : said(fluid, trajectory)) {
        CHECK_THAT(words, !StartsWith("other velocities") && !StartsWith("integration"));
    }
}
