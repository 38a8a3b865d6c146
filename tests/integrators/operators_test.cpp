#include "integrators/operators.hpp"

#include "catch.hpp"

#include "integrators/oscillator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/lattice.hpp"

using namespace ljmd;

namespace {
constexpr Request energy = Request::forces_and_energy;
}

TEST_CASE("a kick changes velocities by dt f / m, each atom's by its own mass, and nothing else") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const State before = state;
    apply({Kick{0.25}}, state, springs, energy);
    state.finish_kick();
    CHECK(state.velocities().col(0) == before.velocities().col(0) + 0.25 / 1.0 * before.forces().col(0));
    CHECK(state.velocities().col(1) == before.velocities().col(1) + 0.25 / 2.5 * before.forces().col(1));
    CHECK(static_cast<const State&>(state).positions() == before.positions());
    CHECK(state.forces_are_current());
}

TEST_CASE("an atom is kicked by its own mass, whatever that of the atom before it") {
    const std::vector<double> masses = {2.5, 2.5, 1.0, 4.0, 1.0};
    for (const bool and_drift : {false, true}) {
        CAPTURE(and_drift);
        test::Oscillator springs(2.0);
        State state(5);
        state.write_masses() = masses;
        for (Index i = 0; i < 5; ++i) {
            state.write_positions().col(i) = Vec3(1.0, -2.0, 3.0);
        }
        springs.evaluate(state, Request::forces);
        apply(and_drift ? std::vector<Operator>{Kick{0.25}, Drift{0.5}} : std::vector<Operator>{Kick{0.25}}, state,
              springs, energy);
        state.finish_kick();
        for (Index i = 0; i < 5; ++i) {
            CHECK(static_cast<const State&>(state).velocities().col(i) ==
                  0.25 / masses[static_cast<std::size_t>(i)] * Vec3(-2.0, 4.0, -6.0));
        }
    }
}

TEST_CASE("a drift changes positions by dt v, and makes the forces stale") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const State before = state;
    apply({Drift{0.5}}, state, springs, energy);
    CHECK(static_cast<const State&>(state).positions() == before.positions() + 0.5 * before.velocities());
    CHECK(static_cast<const State&>(state).velocities() == before.velocities());
    CHECK_FALSE(state.forces_are_current());
}

TEST_CASE("a drift in a box lands on its grid and does not wrap") {
    test::Oscillator springs(1.0);
    const Box box(Vec3::Constant(3.0));
    State state(1, box);
    state.write_positions().col(0) = box.snap(Vec3::Constant(2.9));
    state.write_velocities().col(0) = Vec3(1.0 / 3.0, -0.1, 0.7);
    const Vec3 r = state.positions().col(0);
    apply({Drift{0.3}}, state, springs, energy);
    const Vec3 moved = static_cast<const State&>(state).positions().col(0);
    CHECK(moved == box.snap(r + 0.3 * state.velocities().col(0)));
    CHECK(moved == ((moved / box.resolution()).array().round() * box.resolution()).matrix());
    CHECK(moved[2] > 3.0);
    CHECK(state.image(0) == Eigen::Vector3i::Zero());
}

TEST_CASE("a kick with stale forces is refused and changes nothing") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    CHECK_THROWS_AS(apply({Drift{0.1}, Kick{0.1}}, state, springs, energy), ContractViolation);

    State moved = test::swinging(springs);
    moved.write_positions()(0, 0) += 0.1;
    const Eigen::Matrix3Xd velocities = static_cast<const State&>(moved).velocities();
    CHECK_THROWS_AS(apply({Kick{0.1}, Evaluate{}}, moved, springs, energy), ContractViolation);
    CHECK(static_cast<const State&>(moved).velocities() == velocities);
    CHECK_NOTHROW(apply({Evaluate{}, Kick{0.1}}, moved, springs, energy));
}

TEST_CASE("an update runs in its place, and is refused when the forces are stale") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const Update stretch{[](State& s) { s.write_positions() *= 2.0; }};
    const Eigen::Matrix3Xd before = test::positions(state);
    apply({stretch, Evaluate{}, stretch}, state, springs, energy);
    CHECK(test::positions(state) == 4.0 * before);
    CHECK_THROWS_AS(apply({stretch}, state, springs, energy), ContractViolation);
    CHECK(test::positions(state) == 4.0 * before);
}

TEST_CASE("velocities may be thermalised while forces are stale") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const Eigen::Matrix3Xd before = test::velocities(state);
    apply({Drift{0.1}, Thermalise{[](State& s) { s.write_velocities() *= 2.0; }}}, state, springs, energy);
    CHECK(test::velocities(state) == 2.0 * before);
    CHECK_FALSE(state.forces_are_current());
}

TEST_CASE("a method that solves by itself gets the force field, and leaves the forces stale") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const Eigen::Matrix3Xd before = test::positions(state);
    const Solve solve{[](State& s, ForceField& forces, const StateWatch& within) {
        s.write_positions() *= 2.0;
        if (within) {
            within(s);
        }
        forces.evaluate(s, Request::forces);
        s.write_positions() *= 2.0;
    }};
    const std::size_t asked = springs.requests().size();
    apply({solve}, state, springs, energy);
    CHECK(springs.requests().size() == asked + 1);
    CHECK(test::positions(state) == 4.0 * before);
    std::vector<Eigen::Matrix3Xd> seen;
    apply({solve}, state, springs, energy, [&](const State& s) { seen.push_back(test::positions(s)); });
    REQUIRE(seen.size() == 1);
    CHECK(seen.front() == 8.0 * before);
    CHECK_FALSE(state.forces_are_current());
}

TEST_CASE("an evaluation passes on whether the order of sums may matter") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    apply({Evaluate{.order_independent = true}}, state, springs, Request::forces);
    CHECK(springs.requests().back() == Request{.order_independent = true});
    apply({Evaluate{}}, state, springs, energy);
    CHECK(springs.requests().back() == Request::forces_and_energy);
}

TEST_CASE("only the last evaluation of a list is asked for more than forces, and its result is returned") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const std::size_t before = springs.requests().size();
    const Evaluation result =
        apply({Drift{0.1}, Evaluate{}, Drift{0.1}, Evaluate{}, Kick{0.1}, Drift{0.1}, Evaluate{}, Kick{0.1}}, state,
              springs, energy);
    const std::vector<Request> asked(springs.requests().begin() + static_cast<std::ptrdiff_t>(before),
                                     springs.requests().end());
    CHECK(asked == std::vector<Request>{Request::forces, Request::forces, energy});
    CHECK(result.potential_energy == state.positions().squaredNorm());

    const Evaluation forces_alone = apply({Evaluate{}}, state, springs, Request::forces);
    CHECK(springs.requests().back() == Request::forces);
    CHECK(forces_alone.potential_energy == 0.0);
}

TEST_CASE("a list without evaluation evaluates nothing, and an empty one does nothing") {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const State before = state;
    const std::size_t asked = springs.requests().size();
    CHECK(apply({}, state, springs, energy).potential_energy == 0.0);
    CHECK(apply({Kick{0.0}, Drift{0.0}}, state, springs, energy).potential_energy == 0.0);
    CHECK(springs.requests().size() == asked);
    CHECK(static_cast<const State&>(state).positions() == before.positions());
    CHECK(static_cast<const State&>(state).velocities() == before.velocities());
}
