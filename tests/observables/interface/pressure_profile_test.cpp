#include "observables/interface/pressure_profile.hpp"

#include "catch.hpp"

#include "forces/pair_force_field.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

const PairPotential potential = PairPotential::lennard_jones("shifted", {2.5, 0.0});

/// Whether two profiles are the same but for rounding.
void check_equal(const PressureProfile& one, const PressureProfile& other) {
    const auto same = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
        return (a - b).cwiseAbs().maxCoeff() < 1e-11 * (1.0 + a.cwiseAbs().maxCoeff());
    };
    CHECK(same(one.density, other.density));
    CHECK(same(one.normal, other.normal));
    CHECK(same(one.tangential, other.tangential));
}

}  // namespace

TEST_CASE("the virial of a pair lies in the layers that its line crosses, by their shares of it") {
    const Box box(Vec3(8.0, 5.0, 20.0));
    // dx = 0.5, dz = -1.2 across the bound of two layers, or across the end of the box.
    const double shift = GENERATE(0.0, 14.0);
    const State state = test::state_of({{1.0, 2.0, 5.5 + shift}, {0.5, 2.0, 6.7 + shift}}, box);
    const PressureProfile profile = pressure_profile(state, potential, 2, 10.0 + shift, 10);  // layers of 2 sigma
    const double w = potential(1.3).w / (8.0 * 5.0 * 2.0);
    CHECK(profile.normal[2] == Approx(w * 1.44 * 0.5 / 1.2));
    CHECK(profile.normal[3] == Approx(w * 1.44 * 0.7 / 1.2));
    CHECK(profile.tangential[2] == Approx(w * 0.125 * 0.5 / 1.2));
    CHECK(profile.tangential[3] == Approx(w * 0.125 * 0.7 / 1.2));
    CHECK(profile.density[2] == Approx(1.0 / 80.0));
    CHECK(profile.density[3] == Approx(1.0 / 80.0));
    CHECK(profile.density.sum() == Approx(2.0 / 80.0));
    CHECK(profile.normal.sum() == Approx(w * 1.44));
    CHECK(profile.tangential.sum() == Approx(w * 0.125));
}

TEST_CASE("a pair that is parallel to the layers counts in its own, and one can be longer than all of them are thick") {
    const Box box(Vec3(8.0, 8.0, 8.0));
    const PressureProfile flat =
        pressure_profile(test::state_of({{1.0, 1.0, 3.3}, {2.0, 1.0, 3.3}}, box), potential, 2, 4.0, 8);
    CHECK(flat.tangential[3] == Approx(0.5 * potential(1.0).w / 64.0));
    CHECK(flat.normal.cwiseAbs().maxCoeff() == 0.0);
    const PressureProfile steep =
        pressure_profile(test::state_of({{1.0, 1.0, 1.0}, {1.0, 1.0, 3.0}}, box), potential, 2, 4.0, 80);
    CHECK(steep.normal.segment(10, 20).minCoeff() == Approx(steep.normal.segment(10, 20).maxCoeff()));
    CHECK(steep.normal.sum() / 10.0 == Approx(potential(2.0).w * 4.0 / 64.0));
}

TEST_CASE("the means over the layers are the density and the pressure tensor") {
    State state = test::shaken_crystal(4, 0.7, 0.1, 5);
    draw_velocities(state, 0.9, 3);
    shift_velocities(state, Vec3(0.3, -0.2, 0.1));
    PairForceField force_field(potential, make_pair_search("cells", 0.0));
    const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    const Thermodynamics sample = thermodynamics(state, evaluation, TailCorrection());
    const Mat3 p = sample.pressure_tensor.value();
    for (const Index axis : {0, 1, 2}) {
        const PressureProfile profile = pressure_profile(state, potential, axis, 1.234, 30);
        CHECK(profile.density.mean() == Approx(sample.density).epsilon(1e-12));
        CHECK(profile.normal.mean() == Approx(p(axis, axis)).epsilon(1e-11));
        CHECK(profile.tangential.mean() == Approx(0.5 * (p.trace() - p(axis, axis))).epsilon(1e-11));
    }
}

TEST_CASE("profiles move with the atoms, and no number of threads changes a bit") {
    State state = test::shaken_crystal(4, 0.7, 0.1, 6);
    draw_velocities(state, 0.9, 3);
    const PressureProfile profile = pressure_profile(state, potential, 2, 2.0, 24);
    State moved = state;
    auto r = moved.write_positions();
    for (Index i = 0; i < moved.count(); ++i) {
        r.col(i) = moved.snapped(r.col(i) + Vec3(0.0, 0.0, 0.625));
    }
    moved.wrap();
    check_equal(profile, pressure_profile(moved, potential, 2, 2.625, 24));

    State other(state.count(), state.box(), Execution({.threads = 3}));
    other.write_positions() = state.positions();
    other.write_velocities() = state.velocities();
    const PressureProfile by_three = pressure_profile(other, potential, 2, 2.0, 24);
    CHECK(by_three.normal == profile.normal);
    CHECK(by_three.tangential == profile.tangential);
}

TEST_CASE("the middle of a film is found wherever it lies") {
    const Box box(Vec3(5.0, 5.0, 20.0));
    const double middle = GENERATE(4.0, 9.5, 19.9);
    std::vector<Vec3> positions;
    for (int k = -10; k <= 10; ++k) {
        const double z = middle + 0.2 * k;
        positions.emplace_back(1.0, 1.0, z - 20.0 * std::floor(z / 20.0));
    }
    const double found = film_centre(test::state_of(positions, box), 2);
    CHECK(std::cos(2.0 * 3.14159265358979 * (found - middle) / 20.0) == Approx(1.0));
}
