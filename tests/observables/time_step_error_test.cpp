#include "observables/time_step_error.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

/// Atoms of masses 1 and 2, with these velocities and forces along x.
State two_atoms(const Vec3& velocities, const Vec3& forces) {
    State state(2, Box(Vec3(5.0, 5.0, 5.0)));
    state.write_masses()[1] = 2.0;
    for (Index i = 0; i < 2; ++i) {
        state.write_velocities().col(i) = Vec3(velocities[i], 0.0, 0.0);
        state.write_forces().col(i) = Vec3(forces[i], 0.0, 0.0);
    }
    return state;
}

}  // namespace

TEST_CASE("The error of a time step is the mean kinetic energy that half a step adds, over that at the steps") {
    TimeStepError error;
    CHECK_FALSE(error.value());
    error.add(two_atoms({3.0, 1.0, 0.0}, {10.0, 6.0, 0.0}), 0.1);
    // 0.1^2/4 (100/1 + 36/2 - 16^2/3) over 9 + 2 - 5^2/3
    CHECK(error.value().value() == Approx(0.0025 * 98.0 / 8.0).epsilon(1e-13));
    error.add(two_atoms({1.0, 0.0, 0.0}, {0.0, 4.0, 0.0}), 0.1);
    CHECK(error.value().value() == Approx(0.0025 * 106.0 / 10.0).epsilon(1e-13));
}

TEST_CASE("Atoms at rest tell nothing of a time step, and what was found is archived") {
    TimeStepError error;
    error.add(two_atoms({0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}), 0.1);
    CHECK_FALSE(error.value());
    error.add(two_atoms({1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}), 0.1);
    Archive a;
    error.archive(a);
    TimeStepError other;
    Archive same(a.bytes());
    other.archive(same);
    CHECK(other.value() == error.value());
}
