#include "judge/velocity_diagnosis.hpp"

#include <functional>
#include "catch.hpp"

#include "judge/right_trajectory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// What is said of velocities that a function of frame and atom makes.
std::string said_of(const std::function<Vec3(const JudgedFrame&, std::size_t)>& velocity) {
    JudgedTrajectory trajectory = right_trajectory(shaken_crystal(), {0, 1, 10});
    for (JudgedFrame& frame : trajectory.frames) {
        for (std::size_t i = 0; i < frame.velocities.size(); ++i) {
            frame.velocities[i] = velocity(frame, i);
        }
    }
    return diagnose_velocities(trajectory, engine_agreement({})).value_or("");
}

const Vec3& right_velocity(const JudgedFrame& frame, std::size_t i) {
    return frame.our_velocities[i];
}

}  // namespace

TEST_CASE("right velocities have no diagnosis") {
    CHECK(said_of(right_velocity).empty());
}

TEST_CASE("velocities of another time are named: half a step, and a whole one, which is nearly two halves") {
    CHECK_THAT(
        said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
            return right_velocity(frame, i) - 0.5 * dt * frame.our_forces[i];
        }),
        StartsWith("half-step velocities: in the frame of step 0 velocities are those of half a time step earlier"));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
                   return frame.before.velocities.empty() ? right_velocity(frame, i) : frame.before.velocities[i];
               }),
               StartsWith("one step late: velocities in the frame of step 1 are those of step 0"));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 { return frame.after.velocities[i]; }),
               StartsWith("one step early: velocities in the frame of step 0 are those of step 1"));
}

TEST_CASE("velocities that leave the kinetic energy as it is are named: by sign, by columns, by rows") {
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 { return -right_velocity(frame, i); }),
               Contains("they have the wrong sign"));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
                   const Vec3& v = right_velocity(frame, i);
                   return {v[1], v[0], v[2]};
               }),
               Contains("stand in other columns, as (vy, vx, vz)"));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
                   const Vec3& v = right_velocity(frame, i);
                   return {v[0], v[1], -v[2]};
               }),
               Contains("stand in other columns, as (vx, vy, -vz)"));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
                   return right_velocity(frame, i < 2 ? 1 - i : i);
               }),
               StartsWith("another order: in the frame of step 0, velocities of 2 of 108 atoms"));
    CHECK_THAT(
        said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 { return right_velocity(frame, (i + 1) % 108); }),
        Contains("velocities of 108 of 108 atoms"));
}

TEST_CASE("other velocities are named: a factor, a motion of the whole, one atom") {
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 { return dt * right_velocity(frame, i); }),
               Contains("they are 0.004 times the right ones"));
    CHECK_THAT(said_of([](const JudgedFrame&, std::size_t) -> Vec3 { return Vec3::Zero(); }), Contains("are all zero"));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
                   return right_velocity(frame, i) + Vec3(0.25, 0.0, 0.0);
               }),
               Contains("they have (0.25, 0, 0) added") || Contains("they have (0.25, -0, 0) added") ||
                   Contains("they have (0.25, "));
    CHECK_THAT(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
                   return i == 17 ? Vec3(right_velocity(frame, i) * 1.5) : right_velocity(frame, i);
               }),
               Contains("right but for one atom, the one of id 18"));
    CHECK(said_of([](const JudgedFrame& frame, std::size_t i) -> Vec3 {
              return right_velocity(frame, i) + Vec3(0.1 * std::sin(static_cast<double>(i * i)), 0.0, 0.0);
          }).empty());
}
