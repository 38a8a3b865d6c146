#include "forces/atom_energies.hpp"

#include <numeric>
#include "catch.hpp"

#include "forces/evaluated.hpp"
#include "forces/every_potential.hpp"
#include "ljmd/core/errors.hpp"
#include "potentials/twelve_six.hpp"

using namespace ljmd;

namespace {

double sum_of(const std::vector<double>& energies) {
    return std::accumulate(energies.begin(), energies.end(), 0.0);
}

double pair_energy(double r) {
    return 4.0 * (std::pow(r, -12) - std::pow(r, -6));
}

}  // namespace

TEST_CASE("energies of atoms sum to the energy of the kernels, of every potential") {
    const State state = test::fluid();
    for (const PairPotential& potential : test::every_potential()) {
        CAPTURE(potential.formula(), potential.truncation());
        const test::Evaluated found = test::evaluate({potential, make_pair_search("verlet-list", 0.3)}, state);
        CHECK(sum_of(atom_energies(state, potential)) ==
              Approx(found.evaluation.potential_energy).epsilon(1e-13).margin(1e-11));
    }
    const PairPotential theirs = PairPotential::custom("twelve-six", test::TwelveSix{}, "cut", test::default_cutoff);
    const PairPotential ours = PairPotential::lennard_jones("cut", test::default_cutoff);
    CHECK(atom_energies(state, theirs) == atom_energies(state, ours));
}

TEST_CASE("each atom has half of the energies of its pairs, also across the walls of the box") {
    const Box box(Vec3(6.0, 7.0, 8.0));
    // 0 and 1 are 1.2 apart through the x wall, 1 and 2 are 1.5 apart; 0 and 2 are 2.7 apart, beyond the cutoff.
    const State state = test::state_of({{5.7, 3.0, 4.0}, {0.9, 3.0, 4.0}, {2.4, 3.0, 4.0}}, box);
    const std::vector<double> found = atom_energies(state, PairPotential::lennard_jones("cut", {2.5, 0.0}));
    REQUIRE(found.size() == 3);
    CHECK(found[0] == Approx(0.5 * pair_energy(1.2)).epsilon(1e-14));
    CHECK(found[1] == Approx(0.5 * (pair_energy(1.2) + pair_energy(1.5))).epsilon(1e-14));
    CHECK(found[2] == Approx(0.5 * pair_energy(1.5)).epsilon(1e-14));
}

TEST_CASE("energies of atoms have the same bits with any number of threads and in any order in memory") {
    const PairPotential potential = PairPotential::lennard_jones("shifted", {2.5, 0.0});
    const State one = test::shaken_crystal(6, 0.8442, 0.15, 3, Execution({.threads = 1}));
    const std::vector<double> expected = atom_energies(one, potential);
    for (const int threads : {2, 3, 5}) {
        CHECK(atom_energies(test::shaken_crystal(6, 0.8442, 0.15, 3, Execution({.threads = threads})), potential) ==
              expected);
    }
    State moved = one;
    PairForceField(potential, make_pair_search("verlet-list", 0.3)).evaluate(moved, Request::forces);
    REQUIRE(moved.ids() != one.ids());  // the list has reordered the atoms
    CHECK(atom_energies(moved, potential) == expected);
}

TEST_CASE("energies of atoms change with the work of the forces") {
    const PairPotential potential = PairPotential::lennard_jones("force-shifted", {2.5, 0.0});
    const State state = test::fluid();
    const Eigen::Matrix3Xd forces = test::evaluate({potential, make_pair_search("all-pairs", 0.0)}, state).forces;
    constexpr double h = 1e-5;
    for (const Index atom : {0, 31, 107}) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto energy_at = [&](double by) {
                State there = state;
                there.write_positions()(axis, atom) += by;
                there.write_positions().col(atom) = there.snapped(there.positions().col(atom));
                return sum_of(atom_energies(there, potential));
            };
            CHECK((energy_at(-h) - energy_at(h)) / (2.0 * h) == Approx(forces(axis, atom)).epsilon(1e-6).margin(1e-6));
        }
    }
}

TEST_CASE("one atom has no energy, and a box that is too small for the cutoff is refused") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    CHECK(atom_energies(test::state_of({{1.0, 1.0, 1.0}}, Box(Vec3(5.0, 5.0, 5.0))), potential) ==
          std::vector<double>{0.0});
    CHECK_THROWS_AS(atom_energies(test::state_of({{1.0, 1.0, 1.0}}, Box(Vec3(4.9, 6.0, 6.0))), potential),
                    ContractViolation);
}
