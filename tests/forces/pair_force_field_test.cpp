#include "forces/pair_force_field.hpp"

#include <limits>
#include "catch.hpp"

#include "forces/evaluated.hpp"
#include "forces/every_potential.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

using test::evaluate;
using test::Evaluated;
using test::every_potential;
using test::fluid;
using test::rms;
constexpr Cutoff usual = test::default_cutoff;

PairForceField lennard_jones(const std::string& truncation, const std::string& search, const Cutoff& cutoff = usual) {
    return {PairPotential::lennard_jones(truncation, cutoff), make_pair_search(search, 0.3)};
}

/// Energy, virial and forces by a plain double loop over pairs, images by rounding: written apart from the library.
Evaluated by_hand(const PairPotential& potential, const State& state) {
    Evaluated result{Eigen::Matrix3Xd::Zero(3, state.count()), {}};
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = 0; j < i; ++j) {
            Vec3 d = state.positions().col(i) - state.positions().col(j);
            d -= d.cwiseQuotient(state.box().edges()).array().round().matrix().cwiseProduct(state.box().edges());
            const PairTerm<double> term = potential(d.norm());
            const Vec3 f = term.w * d;
            result.forces.col(i) += f;
            result.forces.col(j) -= f;
            result.evaluation.potential_energy += term.u;
            result.evaluation.virial += d * f.transpose();
        }
    }
    return result;
}

State two_atoms(double r, const Vec3& direction = Vec3::UnitX()) {
    const Vec3 first(1.0, 1.0, 1.0);
    return test::state_of({first, first + r * direction}, Box(Vec3::Constant(8.0)));
}

}  // namespace

TEST_CASE("every search gives the forces, energy and virial of a plain sum over pairs, for every potential") {
    const State state = fluid();
    for (const PairPotential& potential : every_potential()) {
        CAPTURE(potential.formula(), potential.truncation());
        const Evaluated expected = by_hand(potential, state);
        const double scale = rms(expected.forces);
        REQUIRE(scale > 1.0);
        for (const std::string& search : pair_search_names()) {
            CAPTURE(search);
            const Evaluated found = evaluate({potential, make_pair_search(search, 0.3)}, state);
            CHECK((found.forces - expected.forces).colwise().norm().maxCoeff() < 1e-13 * scale);
            CHECK(found.evaluation.potential_energy ==
                  Approx(expected.evaluation.potential_energy).epsilon(1e-13).margin(1e-11));
            CHECK((found.evaluation.virial - expected.evaluation.virial).norm() <
                  1e-13 * (expected.evaluation.virial.norm() + scale * 108.0));
        }
    }
}

TEST_CASE("searches agree in elongated boxes, at many densities and skins") {
    const double density = GENERATE(0.05, 0.5, 1.1);
    const Box box(Vec3(5.0, 6.2, 13.0));
    const auto atoms = static_cast<Index>(density * box.volume());
    State state(atoms, box);
    {
        // Random atoms, but none nearer than 0.7 to another: rejected ones try again.
        Index placed = 0;
        for (const Vec3& r : random_positions(200 * atoms, box, 3)) {
            bool free = true;
            for (Index j = 0; j < placed && free; ++j) {
                free = box.minimum_image(r - state.positions().col(j)).norm() > 0.7;
            }
            if (free && placed < atoms) {
                state.write_positions().col(placed++) = r;
            }
        }
        REQUIRE(placed == atoms);
    }
    const Evaluated oracle = evaluate(lennard_jones("cut", "all-pairs"), state);
    for (const double skin : {0.0, 0.3, 1.0}) {
        for (const std::string& search : pair_search_names()) {
            CAPTURE(search, skin, density);
            const PairForceField force_field(PairPotential::lennard_jones("cut", usual),
                                             make_pair_search(search, skin));
            const Evaluated found = evaluate(force_field, state);
            CHECK((found.forces - oracle.forces).colwise().norm().maxCoeff() < 1e-13 * rms(oracle.forces));
        }
    }
}

TEST_CASE("forces are minus the gradient of the energy, for every potential") {
    // The first random fluid in which no pair is so near the cutoff that the step could carry it across: there the
    // energy of `cut` jumps, and the force of `shifted`.
    const double h = 1e-5;
    const auto far_from_cutoff = [&](const State& state) {
        double nearest = 1.0;
        for (Index i = 0; i < state.count(); ++i) {
            for (Index j = 0; j < i; ++j) {
                const Vec3 d = state.box().minimum_image(state.positions().col(i) - state.positions().col(j));
                nearest = std::min(nearest, std::abs(d.norm() - usual.radius));
            }
        }
        return nearest > 2.0 * h;
    };
    std::uint64_t seed = 1;
    State state = fluid(seed);
    for (state.wrap(); !far_from_cutoff(state); state.wrap()) {
        state = fluid(++seed);
        REQUIRE(seed < 100);
    }

    for (const PairPotential& potential : every_potential()) {
        CAPTURE(potential.formula(), potential.truncation());
        PairForceField force_field(potential, make_pair_search("all-pairs", 0.0));  // keeps the order of the atoms
        force_field.evaluate(state, Request::forces);
        const Eigen::Matrix3Xd forces = state.forces();
        double largest = 0.0;
        for (Index i = 0; i < state.count(); i += 4) {
            for (int a = 0; a < 3; ++a) {
                const double x = state.positions()(a, i);
                const auto energy_at = [&](double moved) {
                    state.write_positions()(a, i) = moved;
                    return force_field.evaluate(state, Request::forces_and_energy).potential_energy;
                };
                const double above = state.snapped(Vec3::Constant(x + h))[0];
                const double below = state.snapped(Vec3::Constant(x - h))[0];
                const double slope = (energy_at(above) - energy_at(below)) / (above - below);
                energy_at(x);
                state.wrap();  // a step across a wall counts an edge, and is taken back
                largest = std::max(largest, std::abs(forces(a, i) + slope));
            }
        }
        CHECK(largest < 1e-7 * rms(forces));
    }
}

TEST_CASE("action equals reaction: forces add up to nothing") {
    const State state = fluid();
    for (const PairPotential& potential : every_potential()) {
        for (const std::string& search : pair_search_names()) {
            const Evaluated found = evaluate({potential, make_pair_search(search, 0.3)}, state);
            CAPTURE(potential.formula(), potential.truncation(), search);
            CHECK(found.forces.rowwise().sum().norm() < 1e-12 * rms(found.forces));
        }
    }
}

TEST_CASE("the virial tensor is symmetric, and its trace is the sum of r.f over pairs") {
    const State state = fluid();
    for (const std::string& search : pair_search_names()) {
        const Evaluated found = evaluate(lennard_jones("force-shifted", search), state);
        CHECK(found.evaluation.virial == found.evaluation.virial.transpose());
        double sum = 0.0;
        const PairPotential potential = PairPotential::lennard_jones("force-shifted", usual);
        for (Index i = 0; i < state.count(); ++i) {
            for (Index j = 0; j < i; ++j) {
                const double r = state.box().minimum_image(state.positions().col(i) - state.positions().col(j)).norm();
                sum += potential(r).w * r * r;
            }
        }
        CHECK(found.evaluation.virial.trace() == Approx(sum).epsilon(1e-12));
    }
}

TEST_CASE("asking for forces alone gives the same forces bit for bit, and zeros for the rest") {
    const State state = fluid();
    for (const PairPotential& potential : every_potential()) {
        for (const std::string& search : pair_search_names()) {
            const PairForceField force_field(potential, make_pair_search(search, 0.3));
            const Evaluated alone = evaluate(force_field, state, Request::forces);
            const Evaluated both = evaluate(force_field, state, Request::forces_and_energy);
            CAPTURE(potential.formula(), potential.truncation(), search);
            CHECK(alone.forces == both.forces);
            CHECK(alone.evaluation.potential_energy == 0.0);
            CHECK(alone.evaluation.virial == Mat3::Zero());
            CHECK(both.evaluation.potential_energy != 0.0);
        }
    }
}

TEST_CASE("evaluating again, and evaluating a copy, gives the same bits, forces are then current") {
    for (const std::string& search : pair_search_names()) {
        CAPTURE(search);
        State state = fluid();
        PairForceField force_field = lennard_jones("switched", search);
        CHECK_FALSE(state.forces_are_current());
        const Evaluation first = force_field.evaluate(state, Request::forces_and_energy);
        CHECK(state.forces_are_current());
        const Eigen::Matrix3Xd forces = test::by_id(state, state.forces());
        const Evaluation second = force_field.evaluate(state, Request::forces_and_energy);
        CHECK(test::by_id(state, state.forces()) == forces);
        CHECK(second.potential_energy == first.potential_energy);
        CHECK(second.virial == first.virial);
        CHECK(evaluate(lennard_jones("switched", search), state).forces == forces);
        CHECK(force_field.search_statistics().preparations == 2);
    }
}

TEST_CASE("forces do not depend on what the force field has evaluated before") {
    for (const std::string& search : pair_search_names()) {
        State state = fluid();
        PairForceField used = lennard_jones("cut", search);
        std::mt19937_64 generator(8);
        for (int step = 0; step < 15; ++step) {
            used.evaluate(state, Request::forces);
            test::displace(state, 0.06, generator);
        }
        const Evaluated oracle = evaluate(lennard_jones("cut", "all-pairs"), state);
        const Evaluated found = evaluate(used, state);
        CHECK((found.forces - oracle.forces).colwise().norm().maxCoeff() < 1e-13 * rms(oracle.forces));
    }
}

TEST_CASE("two atoms attract and repel along their separation, as the formula says") {
    for (const std::string& search : pair_search_names()) {
        for (const double r : {0.9, 1.0, 1.5, 2.4}) {
            for (const Vec3& direction : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, -0.6, 0.8)}) {
                State state = two_atoms(r, direction);
                PairForceField force_field = lennard_jones("cut", search);
                const Evaluation found = force_field.evaluate(state, Request::forces_and_energy);
                const Eigen::Matrix3Xd f = test::by_id(state, state.forces());
                const double attraction = 24.0 * (std::pow(r, -7) - 2.0 * std::pow(r, -13));  // u'(r)
                CHECK((f.col(0) - attraction * direction).norm() < 1e-12 * std::abs(attraction));
                CHECK(f.col(0) == -f.col(1));
                CHECK(found.potential_energy == Approx(4.0 * (std::pow(r, -12) - std::pow(r, -6))).margin(1e-12));
                CHECK(found.virial.trace() == Approx(-attraction * r));
                CHECK(found.virial.isApprox(-attraction * r * direction * direction.transpose(), 1e-12));
            }
        }
    }
}

TEST_CASE("atoms on opposite sides of the box are neighbours across the wall") {
    for (const std::string& search : pair_search_names()) {
        State state = test::state_of({{0.25, 0.25, 0.25}, {7.75, 7.5, 7.25}}, Box(Vec3::Constant(8.0)));
        PairForceField force_field = lennard_jones("cut", search);
        force_field.evaluate(state, Request::forces);
        const Vec3 d(0.5, 0.75, 1.0);
        const Vec3 expected = PairPotential::lennard_jones("cut", usual)(d.norm()).w * d;
        CHECK((test::by_id(state, state.forces()).col(0) - expected).norm() < 1e-14 * expected.norm());
    }
}

TEST_CASE("a pair at the cutoff does not count, one on the next grid point inside does") {
    const Box box(Vec3::Constant(5.0));  // L = 2 rc: the atoms are on both sides of each other
    const double inside = 2.5 - box.resolution();
    const double u = PairPotential::lennard_jones("cut", usual)(inside).u;
    REQUIRE(u < -0.01);
    for (const std::string& search : pair_search_names()) {
        CAPTURE(search);
        PairForceField force_field = lennard_jones("cut", search);
        const auto energy = [&](double x) {
            State state = test::state_of({Vec3::Zero(), {x, 0.0, 0.0}}, box);
            return force_field.evaluate(state, Request::forces_and_energy).potential_energy;
        };
        CHECK(energy(2.5) == 0.0);
        CHECK(energy(inside) == u);
        CHECK(energy(5.0 - inside) == u);
    }
}

TEST_CASE("a pair at the cutoff counts when the cutoff is an ulp larger") {
    for (const std::string& search : pair_search_names()) {
        State state = two_atoms(2.375);
        const auto energy = [&](double cutoff) {
            PairForceField force_field = lennard_jones("cut", search, {cutoff, 0.0});
            return force_field.evaluate(state, Request::forces_and_energy).potential_energy;
        };
        CHECK(energy(2.375) == 0.0);
        CHECK(energy(std::nextafter(2.375, 3.0)) < -0.01);
    }
}

TEST_CASE("the forces at rc jump for `cut` and `shifted`, and vanish for the smooth truncations") {
    State state = two_atoms(2.5 - 1e-7);
    const auto force = [&state](const std::string& truncation) {
        lennard_jones(truncation, "all-pairs").evaluate(state, Request::forces);
        return static_cast<const State&>(state).forces().col(0).norm();
    };
    CHECK(force("cut") == Approx(0.039).epsilon(0.01));
    CHECK(force("shifted") == Approx(0.039).epsilon(0.01));
    CHECK(force("force-shifted") < 1e-7);
    CHECK(force("switched") < 1e-12);
}

TEST_CASE("one atom and no atom have neither forces nor energy") {
    for (const std::string& search : pair_search_names()) {
        for (const Index atoms : {0, 1}) {
            State state = test::random_state(atoms, Box(Vec3::Constant(5.0)), 1);
            PairForceField force_field = lennard_jones("cut", search);
            const Evaluation found = force_field.evaluate(state, Request::forces_and_energy);
            CHECK(found.potential_energy == 0.0);
            CHECK(found.virial == Mat3::Zero());
            CHECK(static_cast<const State&>(state).forces() == Eigen::Matrix3Xd::Zero(3, atoms));
            CHECK(state.forces_are_current());
        }
    }
}

TEST_CASE("a cutoff beyond half the shortest edge is refused, half of it is not") {
    for (const std::string& search : pair_search_names()) {
        const double edge = 5.0;
        const Box legal(Vec3(edge, 9.0, edge));
        const Box illegal(Vec3(9.0, edge - Box(Vec3::Constant(9.0)).resolution(), 9.0));
        State fits = test::random_state(4, legal, 1);
        State does_not = test::random_state(4, illegal, 1);
        PairForceField force_field = lennard_jones("cut", search);
        CHECK_NOTHROW(force_field.evaluate(fits, Request::forces));
        CHECK_THROWS_AS(force_field.evaluate(does_not, Request::forces), ContractViolation);
        CHECK_FALSE(does_not.forces_are_current());
        State unbounded(4);
        CHECK_THROWS_AS(force_field.evaluate(unbounded, Request::forces), ContractViolation);
    }
}

TEST_CASE("positions that are not finite are reported, and the forces are not called current") {
    for (const std::string& search : pair_search_names()) {
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            State state = fluid();
            PairForceField force_field = lennard_jones("cut", search);
            force_field.evaluate(state, Request::forces);
            state.write_positions()(1, 17) = bad;
            CHECK_THROWS_AS(force_field.evaluate(state, Request::forces), PhysicsError);
            CHECK_FALSE(state.forces_are_current());
        }
    }
}

TEST_CASE("coincident atoms give forces that are not finite instead of wrong ones") {
    for (const std::string& search : pair_search_names()) {
        State state = test::state_of({Vec3::Constant(1.0), Vec3::Constant(1.0)}, Box(Vec3::Constant(8.0)));
        PairForceField force_field = lennard_jones("cut", search);
        const Evaluation found = force_field.evaluate(state, Request::forces_and_energy);
        CHECK_FALSE(std::isfinite(found.potential_energy));
        CHECK_FALSE(static_cast<const State&>(state).forces().allFinite());
    }
}

TEST_CASE("energies of many blocks of atoms add up: a crystal has the energy of its cell times its cells") {
    // 2048 atoms are 8 blocks of the sum. All sites of a crystal are alike, so U/N is a lattice sum.
    const double constant = 1.6;
    const State large = test::crystal_state(Lattice::fcc, 8, Box(Vec3::Constant(8.0 * constant)));
    const State small = test::crystal_state(Lattice::fcc, 4, Box(Vec3::Constant(4.0 * constant)));
    for (const std::string& search : pair_search_names()) {
        const Evaluated a = evaluate(lennard_jones("switched", search), large);
        const Evaluated b = evaluate(lennard_jones("switched", search), small);
        CHECK(a.evaluation.potential_energy == Approx(8.0 * b.evaluation.potential_energy).epsilon(1e-13));
        CHECK(a.evaluation.virial.trace() == Approx(8.0 * b.evaluation.virial.trace()).epsilon(1e-12));
    }
}

TEST_CASE("the force field tells its potential and its search") {
    const PairForceField force_field = lennard_jones("shifted", "cells", {2.25, 0.0});
    CHECK(force_field.potential().truncation() == "shifted");
    CHECK(force_field.potential().cutoff().radius == 2.25);
    CHECK(std::holds_alternative<LinkedCells>(force_field.search()));
    CHECK(force_field.search_statistics().preparations == 0);
}
