#include "integrators/relaxation.hpp"

#include "catch.hpp"

#include "forces/pair_force_field.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

PairForceField lennard_jones(double cutoff = 2.5) {
    return {PairPotential::lennard_jones("cut", {cutoff, 0.0}), make_pair_search("verlet-list", 0.3)};
}

double closest_pair(const State& state) {
    double nearest = 1e300;
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = 0; j < i; ++j) {
            const Vec3 d = state.box().minimum_image(state.positions().col(i) - state.positions().col(j));
            nearest = std::min(nearest, d.norm());
        }
    }
    return nearest;
}

double largest_force(const State& state) {
    return state.forces().colwise().norm().maxCoeff();
}

}  // namespace

TEST_CASE("a random start at the density of the liquid is relaxed, and left as the first step needs it") {
    const std::uint64_t seed = GENERATE(1u, 2u, 3u);
    State state = test::random_state(500, cubic_box(500, 0.8442), seed);
    draw_velocities(state, 5.0, seed);
    state.set_image(3, Eigen::Vector3i(1, -2, 0));
    REQUIRE(closest_pair(state) < 0.3);
    PairForceField force_field = lennard_jones();
    const Relaxation result = relax(state, force_field);

    CHECK(result.iterations > 0);
    CHECK(result.iterations < 150);  // 101 to 103; without steering towards the force 190 and more
    CHECK(result.largest_force <= 10.0);
    CHECK(closest_pair(state) > 0.8);

    CHECK(static_cast<const State&>(state).velocities().isZero(0.0));
    for (Index i = 0; i < state.count(); ++i) {
        CHECK(state.image(i) == Eigen::Vector3i::Zero());
    }
    const auto r = static_cast<const State&>(state).positions();
    CHECK((r.array() >= 0.0).all());
    CHECK(((r.colwise() - state.box().edges()).array() < 0.0).all());

    CHECK(state.forces_are_current());
    CHECK(largest_force(state) == Approx(result.largest_force).epsilon(1e-14));
    const Eigen::Matrix3Xd forces = test::by_id(state, static_cast<const State&>(state).forces());
    PairForceField fresh = lennard_jones();
    const Evaluation evaluation = fresh.evaluate(state, Request::forces_and_energy);
    CHECK((test::by_id(state, static_cast<const State&>(state).forces()) - forces).norm() < 1e-11 * forces.norm());
    CHECK(evaluation.potential_energy == Approx(result.potential_energy).epsilon(1e-12));
}

TEST_CASE("no atom moves farther than a tenth of sigma in an iteration") {
    State state = test::random_state(200, cubic_box(200, 0.8), 4);
    PairForceField force_field = lennard_jones();
    for (int n = 0; n < 30; ++n) {
        const Eigen::Matrix3Xd before = test::by_id(state, static_cast<const State&>(state).positions());
        CHECK_THROWS_AS(relax(state, force_field, 1e-6, 1), PhysicsError);
        const Eigen::Matrix3Xd after = test::by_id(state, static_cast<const State&>(state).positions());
        double farthest = 0.0;
        for (Index i = 0; i < 200; ++i) {
            const Vec3 n_edges = (after.col(i) - before.col(i)).cwiseQuotient(state.box().edges()).array().round();
            const Vec3 d = after.col(i) - before.col(i) - n_edges.cwiseProduct(state.box().edges());
            farthest = std::max(farthest, d.norm());
        }
        CHECK(farthest > 0.0);
        CHECK(farthest < 0.1 * (1.0 + 1e-12));
    }
}

TEST_CASE("the tolerance decides how far the relaxation goes") {
    State state = test::random_state(108, cubic_box(108, 0.7), 5);
    PairForceField force_field = lennard_jones();
    const Relaxation coarse = relax(state, force_field, 10.0);
    const Relaxation fine = relax(state, force_field, 0.1);
    CHECK(fine.iterations > 0);
    CHECK(fine.largest_force <= 0.1);
    CHECK(fine.potential_energy < coarse.potential_energy);
}

TEST_CASE("two atoms settle in the minimum of the potential") {
    State state = test::state_of({{1.0, 1.0, 1.0}, {1.9, 1.0, 1.0}}, Box(Vec3::Constant(6.0)));
    PairForceField force_field = lennard_jones();
    const Relaxation result = relax(state, force_field, 1e-6);
    CHECK(closest_pair(state) == Approx(std::pow(2.0, 1.0 / 6.0)).epsilon(1e-6));
    CHECK(result.potential_energy == Approx(-1.0).epsilon(1e-10));
}

TEST_CASE("velocities of the start do not matter") {
    const auto relaxed = [](const Vec3& velocity) {
        State state = test::state_of({{1.0, 1.0, 1.0}, {2.0, 1.0, 1.0}}, Box(Vec3::Constant(6.0)));
        state.write_velocities().col(0) = velocity;
        PairForceField force_field = lennard_jones();
        relax(state, force_field);
        return Eigen::Matrix3Xd(static_cast<const State&>(state).positions());
    };
    CHECK(relaxed({-5.0, 0.0, 0.0}) == relaxed(Vec3::Zero()));
    CHECK(relaxed({0.0, 5.0, 0.0}) == relaxed(Vec3::Zero()));
}

TEST_CASE("a relaxed start, one atom and no atom need no iteration") {
    PairForceField force_field = lennard_jones();
    State crystal = test::crystal_state(Lattice::fcc, 4, cubic_box(256, 0.9));
    const Relaxation result = relax(crystal, force_field);
    CHECK(result.iterations == 0);
    CHECK(result.potential_energy / 256.0 < -5.0);
    CHECK(crystal.forces_are_current());
    for (const Index atoms : {0, 1}) {
        State state = test::random_state(atoms, Box(Vec3::Constant(5.0)), 1);
        draw_velocities(state, 1.0, 1);
        CHECK(relax(state, force_field).iterations == 0);
        CHECK(static_cast<const State&>(state).velocities().isZero(0.0));
    }
}

TEST_CASE("a relaxation that does not end in time is reported with the force that is left") {
    State state = test::random_state(200, cubic_box(200, 0.8), 6);
    PairForceField force_field = lennard_jones();
    CHECK_THROWS_AS(relax(state, force_field, 10.0, 3), PhysicsError);
    CHECK_THROWS_WITH(relax(state, force_field, 1e-8, 2), Catch::Contains("2 iterations") && Catch::Contains("force"));
}

TEST_CASE("coincident atoms are reported, not taken for relaxed") {
    // Their forces are not numbers; the other atoms feel none.
    State state =
        test::state_of({Vec3::Constant(1.0), Vec3::Constant(1.0), Vec3::Constant(4.0)}, Box(Vec3::Constant(6.0)));
    PairForceField force_field = lennard_jones(1.5);
    CHECK_THROWS_AS(relax(state, force_field), PhysicsError);
}
