#include "ljmd/detail/observables/thermodynamics.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "forces/pair_force_field.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

const TailCorrection no_tail;

Mat3 tensor(double xx, double yy, double zz, double xy, double xz, double yz) {
    Mat3 t;
    t << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return t;
}

}  // namespace

TEST_CASE("the thermodynamics of two atoms, by hand") {
    State state(2, Box(Vec3(2.0, 4.0, 5.0)));  // V = 40
    state.write_masses() = {1.0, 3.0};
    state.write_velocities().col(0) = Vec3(3.0, 0.0, -1.0);
    state.write_velocities().col(1) = Vec3(-1.0, 2.0, 0.0);
    const Evaluation evaluation{-5.0, tensor(1.0, 2.0, 6.0, -4.0, 0.5, 8.0)};
    const Thermodynamics result = thermodynamics(state, evaluation, no_tail);
    // 2 K = (9 + 1) + 3 (1 + 4) = 25; sum m v v = xx 9 + 3, yy 12, zz 1, xy -6, xz -3, yz 0.
    // P = (0, 6, -1) and M = 4: the motion of the centre of mass has no part in the temperature.
    CHECK(result.temperature.value() == Approx((25.0 - 9.25) / 3.0).epsilon(1e-15));
    CHECK(result.density == 0.05);
    CHECK(result.potential_energy == -2.5);
    CHECK(result.kinetic_energy == 6.25);
    CHECK(result.total_energy == 3.75);
    CHECK(result.virial == 9.0);
    // p = rho T + W/(3 V); the tensor has twice sum m v v - P P/M = xx 12, yy 3, zz 0.75, xy -6, xz -3, yz 1.5.
    CHECK(result.pressure.value() == Approx(0.05 * 15.75 / 3.0 + 9.0 / 120.0).epsilon(1e-15));
    CHECK(result.pressure_tensor->isApprox(tensor(25.0, 8.0, 7.5, -16.0, -5.5, 11.0) / 40.0, 1e-15));
    CHECK(virial_pressure(state, evaluation, no_tail) == Approx(9.0 / 120.0).epsilon(1e-15));
    CHECK(mechanical_stress(state, evaluation).isApprox(tensor(13.0, 5.0, 6.75, -10.0, -2.5, 9.5) / 40.0, 1e-15));
}

TEST_CASE("the thermodynamics of a triangle of Lennard-Jones atoms, by hand") {
    // Three pairs at r = 1: u = 0 and r.f = 24 each.
    State state = test::state_of({{1.0, 1.0, 1.0}, {2.0, 1.0, 1.0}, {1.5, 1.0 + std::sqrt(0.75), 1.0}},
                                 Box(Vec3::Constant(10.0)));
    state.write_velocities().col(0) = Vec3(0.0, 0.0, 2.0);
    state.write_velocities().col(2) = Vec3(0.0, 0.0, -2.0);
    PairForceField force_field(PairPotential::lennard_jones("cut", {2.5, 0.0}), make_pair_search("cells", 0.0));
    const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    const Thermodynamics result = thermodynamics(state, evaluation, no_tail);
    CHECK(result.temperature.value() == Approx(8.0 / 6.0));
    CHECK(result.potential_energy == Approx(0.0).margin(1e-13));
    CHECK(result.virial == Approx(72.0).epsilon(1e-13));
    CHECK(result.pressure.value() == Approx((1.5 * 8.0 + 72.0) / 3000.0).epsilon(1e-13));
    // In the plane of the triangle the forces are isotropic; across it only the motion counts.
    CHECK(result.pressure_tensor->isApprox(tensor(36.0, 36.0, 12.0, 0.0, 0.0, 0.0) / 1000.0, 1e-12));
}

TEST_CASE("without forces p V = N T, though 3 N - 3 degrees of freedom move, and whatever the centre of mass does") {
    const double target = 1.75;
    State state = test::random_state(200, Box(Vec3(7.0, 8.0, 9.0)), 5);
    draw_velocities(state, target, 6);
    const Thermodynamics result = thermodynamics(state, Evaluation{}, no_tail);
    CHECK(result.temperature.value() == Approx(target).epsilon(1e-13));
    CHECK(result.kinetic_energy == Approx(1.5 * target * 199.0 / 200.0).epsilon(1e-13));
    CHECK(result.pressure.value() * state.box().volume() == Approx(200.0 * target).epsilon(1e-13));
    State moved = state;
    moved.write_velocities().colwise() += Vec3(0.3, -2.0, 1.0);
    const Thermodynamics moving = thermodynamics(moved, Evaluation{}, no_tail);
    CHECK(moving.temperature.value() == Approx(target).epsilon(1e-12));
    CHECK(moving.pressure.value() == Approx(result.pressure.value()).epsilon(1e-12));
    CHECK(moving.pressure_tensor->isApprox(*result.pressure_tensor, 1e-12));
    CHECK(mechanical_stress(moved, Evaluation{}).isApprox(mechanical_stress(state, Evaluation{}), 1e-12));
    CHECK(result.potential_energy == 0.0);
    CHECK(result.virial == 0.0);
}

TEST_CASE("tail corrections are added once: to the energy per atom, the pressure and the diagonal of its tensor") {
    State state = test::shaken_crystal(4, 0.8442, 0.1, 2);
    draw_velocities(state, 0.722, 3);
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    PairForceField force_field(potential, make_pair_search("cells", 0.0));
    const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    const Thermodynamics bare = thermodynamics(state, evaluation, no_tail);
    const Thermodynamics full = thermodynamics(state, evaluation, TailCorrection(potential));

    const double rho = 0.8442;
    const double r3 = std::pow(2.5, -3);
    const double r9 = r3 * r3 * r3;
    const double energy = 8.0 / 3.0 * std::numbers::pi * rho * (r9 / 3.0 - r3);
    const double pressure = 16.0 / 3.0 * std::numbers::pi * rho * rho * (2.0 * r9 / 3.0 - r3);
    CHECK(full.potential_energy - bare.potential_energy == Approx(energy).epsilon(1e-12));
    CHECK(full.total_energy - bare.total_energy == Approx(energy).epsilon(1e-12));
    CHECK(*full.pressure - *bare.pressure == Approx(pressure).epsilon(1e-12));
    CHECK((*full.pressure_tensor - *bare.pressure_tensor).isApprox(pressure * Mat3::Identity(), 1e-12));
    CHECK(
        *full.pressure ==
        Approx(rho * *full.temperature + virial_pressure(state, evaluation, TailCorrection(potential))).epsilon(1e-12));
    CHECK(full.virial == bare.virial);
    CHECK(full.virial == evaluation.virial.trace());
    CHECK(full.kinetic_energy == bare.kinetic_energy);
    CHECK(full.temperature == bare.temperature);

    for (const Thermodynamics& result : {bare, full}) {
        CHECK(result.pressure_tensor->trace() / 3.0 == Approx(*result.pressure).epsilon(1e-14));
        CHECK(result.total_energy == result.potential_energy + result.kinetic_energy);
    }
    CHECK(*bare.pressure == Approx(rho * *bare.temperature + evaluation.virial.trace() / (3.0 * state.box().volume())));
}

TEST_CASE("one atom has neither temperature nor pressure, but kinetic energy") {
    State state(1, Box(Vec3::Constant(2.0)));
    state.write_velocities().col(0) = Vec3(3.0, 0.0, 0.0);
    const Thermodynamics result = thermodynamics(state, Evaluation{}, no_tail);
    CHECK_FALSE(result.temperature.has_value());
    CHECK(result.kinetic_energy == 4.5);
    CHECK(result.total_energy == 4.5);
    CHECK_FALSE(result.pressure.has_value());
    CHECK_FALSE(result.pressure_tensor.has_value());
}

TEST_CASE("what rounding leaves of the motion of atoms at rest is no temperature to divide by") {
    CHECK_FALSE(is_above_zero(0.0));
    CHECK_FALSE(is_above_zero(1e-30));
    CHECK_FALSE(is_above_zero(std::nan("")));
    CHECK(is_above_zero(1e-15));
}
