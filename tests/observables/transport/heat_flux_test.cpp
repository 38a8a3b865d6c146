#include "observables/transport/heat_flux.hpp"

#include <cmath>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

const PairPotential shifted_pair = PairPotential::lennard_jones("shifted", {2.5, 0.0});

/// The formula, pair by pair with the minimum image, times V.
Vec3 directly(const State& state, const PairPotential& potential) {
    const auto r = state.positions();
    const auto v = state.velocities();
    Vec3 sum = Vec3::Zero();
    for (Index i = 0; i < state.count(); ++i) {
        sum += 0.5 * v.col(i).squaredNorm() * v.col(i);
        for (Index j = i + 1; j < state.count(); ++j) {
            const Vec3 d = state.box().minimum_image(r.col(i) - r.col(j));
            const PairTerm<double> term = potential(d.norm());
            const Vec3 velocities = v.col(i) + v.col(j);
            sum += 0.5 * (term.u * velocities + term.w * d.dot(velocities) * d);
        }
    }
    return sum;
}

/// sum e_i r_i of atoms that are far from the edges of their box: half of each pair's energy belongs to either atom.
Vec3 energy_moment(const Eigen::Matrix3Xd& r, const Eigen::Matrix3Xd& v) {
    Vec3 sum = Vec3::Zero();
    for (Index i = 0; i < r.cols(); ++i) {
        double energy = 0.5 * v.col(i).squaredNorm();
        for (Index j = 0; j < r.cols(); ++j) {
            energy += j == i ? 0.0 : 0.5 * shifted_pair((r.col(i) - r.col(j)).norm()).u;
        }
        sum += energy * r.col(i);
    }
    return sum;
}

}  // namespace

TEST_CASE("the heat flux of two atoms is what the formula gives by hand") {
    const Box box(Vec3(8.0, 9.0, 10.0));
    State state = test::state_of({Vec3(7.5, 4.0, 5.0), Vec3(0.75, 4.0, 5.0)}, box);  // 1.25 apart across an edge
    auto v = state.write_velocities();
    v.col(0) = Vec3(1.0, 2.0, 0.0);
    v.col(1) = Vec3(-1.0, -2.0, 0.0);
    // With opposite velocities all that flows out with one atom flows back with the other.
    CHECK(heat_flux(state, shifted_pair).norm() < 1e-15);
    State three = test::state_of({Vec3(7.5, 4.0, 5.0), Vec3(0.75, 4.0, 5.0), Vec3(4.0, 8.9, 5.0)}, box);
    auto w = three.write_velocities();
    w.col(0) = Vec3(1.0, 0.0, 0.0);
    w.col(1) = Vec3(1.0, 3.0, 0.0);
    w.col(2) = Vec3(-2.0, -3.0, 0.0);  // without neighbours
    const double s6 = std::pow(1.25, -6.0);
    const double u = 4.0 * (s6 * s6 - s6) - 4.0 * (std::pow(2.5, -12.0) - std::pow(2.5, -6.0));
    const double virial = 24.0 * (2.0 * s6 * s6 - s6);  // r f
    // Kinetic: 1/2 (1, 0) + 10/2 (1, 3) + 13/2 (-2, -3); u/2 times (2, 3); the work is done along x, by velocities 1
    // + 1.
    const Vec3 expected(0.5 + 5.0 - 13.0 + u + virial, 15.0 - 19.5 + 1.5 * u, 0.0);
    CHECK((heat_flux(three, shifted_pair) * box.volume() - expected).norm() < 1e-12);
}

TEST_CASE("the heat flux is that of a direct sum over all pairs, with every continuous truncation") {
    for (const char* truncation : {"shifted", "force-shifted", "switched"}) {
        CAPTURE(truncation);
        const PairPotential potential = PairPotential::lennard_jones(truncation, {2.5, 2.0});
        State state = test::shaken_crystal(4, 0.8, 0.2, 3);
        draw_velocities(state, 1.2, 5);
        const Vec3 expected = directly(state, potential) / state.box().volume();
        CHECK(expected.norm() > 0.01);
        CHECK((heat_flux(state, potential) - expected).norm() < 1e-12);
    }
}

TEST_CASE("the heat flux is the rate at which energy moves in an isolated cluster") {
    const Box box(Vec3::Constant(40.0));
    const Box inner(Vec3::Constant(4.0));
    std::vector<Vec3> places;
    for (const Vec3& site : lattice_sites(Lattice::fcc, 2, inner)) {
        places.emplace_back(site + Vec3::Constant(18.0));
    }
    State state = test::state_of(places, box);
    std::mt19937_64 generator(11);
    test::displace(state, 0.1, generator);
    draw_velocities(state, 1.5, 4);
    const Eigen::Matrix3Xd r = state.positions();
    const Eigen::Matrix3Xd v = state.velocities();
    Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, r.cols());
    for (Index i = 0; i < r.cols(); ++i) {
        for (Index j = 0; j < r.cols(); ++j) {
            if (j != i) {
                const Vec3 d = r.col(i) - r.col(j);
                a.col(i) += shifted_pair(d.norm()).w * d;
            }
        }
    }
    // Second order in h, because errors of even order are the same forwards and backwards.
    constexpr double h = 1e-5;
    const Vec3 after = energy_moment(r + h * v + 0.5 * h * h * a, v + h * a);
    const Vec3 before = energy_moment(r - h * v + 0.5 * h * h * a, v - h * a);
    const Vec3 rate = (after - before) / (2.0 * h);
    CHECK(rate.norm() > 1.0);
    CHECK((heat_flux(state, shifted_pair) * box.volume() - rate).norm() < 1e-6 * rate.norm());
}

TEST_CASE("atoms without neighbours carry their kinetic energy") {
    const Box box(Vec3::Constant(60.0));
    State state = test::crystal_state(Lattice::simple_cubic, 5, box);
    draw_velocities(state, 0.9, 2);
    Vec3 expected = Vec3::Zero();
    for (Index i = 0; i < state.count(); ++i) {
        expected += 0.5 * state.velocities().col(i).squaredNorm() * state.velocities().col(i);
    }
    CHECK((heat_flux(state, shifted_pair) * box.volume() - expected).norm() < 1e-12);
}

TEST_CASE("the motion of the fluid as a whole carries no heat") {
    State state = test::shaken_crystal(3, 0.8, 0.2, 3);
    draw_velocities(state, 1.0, 5);
    const Vec3 at_rest = heat_flux(state, shifted_pair);
    shift_velocities(state, Vec3(0.5, -2.0, 3.0));
    CHECK((heat_flux(state, shifted_pair) - at_rest).norm() < 1e-12);
}

TEST_CASE("the heat flux of a box that is too small for the cutoff is refused") {
    CHECK_THROWS_AS(heat_flux(test::random_state(3, Box(Vec3(9.0, 4.9, 9.0)), 1), shifted_pair), ContractViolation);
}
