#include "ljmd/detail/model/state.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archive.hpp"

using namespace ljmd;

namespace {

/// Atoms with numbers of their own in every array, scattered over the box and a little beyond.
State scattered(Index atoms, const Box& box) {
    State state(atoms, box);
    std::mt19937_64 generator(21);
    std::uniform_real_distribution<double> uniform(-0.25, 1.05);
    for (Index i = 0; i < atoms; ++i) {
        const Vec3 fraction(uniform(generator), uniform(generator), uniform(generator));
        const auto x = static_cast<double>(i);
        state.write_positions().col(i) = box.snap(box.edges().cwiseProduct(fraction));
        state.write_velocities().col(i) = Vec3(x, 2.0 * x, -x);
        state.write_forces().col(i) = Vec3(-x, 0.5 * x, 3.0);
        state.write_masses()[static_cast<std::size_t>(i)] = 1.0 + x;
        state.set_image(i, Eigen::Vector3i(static_cast<int>(i), -1, 7));
    }
    return state;
}

State one_atom_at(const Vec3& r, const Vec3& edges = {3.0, 4.0, 5.0}) {
    State state(1, Box(edges));
    state.write_positions().col(0) = r;
    return state;
}

}  // namespace

TEST_CASE("a new state holds atoms of mass 1 at rest at the origin") {
    const State state(5, Box(Vec3(3.0, 4.0, 5.0)));
    CHECK(state.count() == 5);
    CHECK(state.ghost_count() == 0);
    CHECK(state.positions().cols() == 5);
    CHECK(state.positions().isZero(0.0));
    CHECK(state.velocities().isZero(0.0));
    CHECK(state.forces().isZero(0.0));
    CHECK(state.masses() == std::vector<double>(5, 1.0));
    CHECK(state.ids() == std::vector<Index>{0, 1, 2, 3, 4});
    CHECK(state.image(4) == Eigen::Vector3i::Zero());
    CHECK(state.time == 0.0);
    CHECK(state.step == 0);
    CHECK_FALSE(state.forces_are_current());
    CHECK_THROWS_AS(State(-1), ContractViolation);
    CHECK(State(0).positions().cols() == 0);
}

TEST_CASE("a state without a box is unbounded") {
    State state(2);
    CHECK_FALSE(state.has_box());
    CHECK_THROWS_AS(state.box(), ContractViolation);
    CHECK_THROWS_AS(state.wrap(), ContractViolation);
    CHECK_THROWS_AS(state.rescale_to(Box(Vec3::Ones())), ContractViolation);
    const Vec3 r(0.1, -1e9, 1e-30);
    CHECK(state.snapped(r) == r);
    state.write_positions().col(1) = r;
    CHECK(state.unwrapped(1) == r);
    CHECK(State(2, Box(Vec3::Ones())).has_box());
}

TEST_CASE("only new positions make forces stale") {
    State state = scattered(4, Box(Vec3(3.0, 4.0, 5.0)));
    state.mark_forces_current();
    state.write_velocities().setZero();
    state.write_forces().setZero();
    state.write_masses()[0] = 2.0;
    state.wrap();
    state.reorder({3, 2, 1, 0});
    state.set_ghost_count(2);
    state.write_ghosts().setZero();
    CHECK(state.forces_are_current());
    state.write_positions().col(0) = Vec3::Zero();
    CHECK_FALSE(state.forces_are_current());
    state.mark_forces_current();
    state.rescale_to(Box(Vec3(6.0, 8.0, 10.0)));
    CHECK_FALSE(state.forces_are_current());
}

TEST_CASE("snapped positions lie on the grid of the box") {
    const Box box(Vec3(3.1, 4.1, 5.1));
    const Vec3 r(0.1, 0.2, 0.3);
    CHECK(State(1, box).snapped(r) == box.snap(r));
    CHECK(State(1, box).snapped(r) != r);
}

TEST_CASE("wrapping counts the edges crossed and keeps unwrapped positions to the last bit") {
    const Box box(Vec3(3.1, 4.7, 5.9));
    State state = scattered(200, box);
    for (Index i = 0; i < state.count(); ++i) {
        state.set_image(i, Eigen::Vector3i::Zero());
    }
    const Eigen::Matrix3Xd before = state.positions();
    state.wrap();
    int crossed = 0;
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 r = state.positions().col(i);
        CHECK(r.minCoeff() >= 0.0);
        CHECK((box.edges() - r).minCoeff() > 0.0);
        CHECK(state.unwrapped(i) == before.col(i));
        crossed += !state.image(i).isZero();
    }
    CHECK(crossed > 50);
    const Eigen::Matrix3Xd once = state.positions();
    state.wrap();
    CHECK(once == state.positions());
}

TEST_CASE("wrapping adds to the images that are there, at the walls too") {
    State state = one_atom_at({-0.0, 4.0, -5.0});
    state.set_image(0, Eigen::Vector3i(4, 5, 6));
    state.wrap();
    CHECK(state.positions().col(0) == Vec3::Zero());
    CHECK(state.image(0) == Eigen::Vector3i(4, 6, 5));
    CHECK(state.unwrapped(0) == Vec3(12.0, 24.0, 25.0));
}

TEST_CASE("wrapping leaves ghosts where they are") {
    State state = one_atom_at({3.5, 1.0, 1.0});
    state.set_ghost_count(1);
    state.write_ghosts().col(0) = Vec3(-0.5, 9.0, 1.0);
    state.wrap();
    CHECK(state.positions().col(0) == Vec3(0.5, 1.0, 1.0));
    CHECK(state.positions_and_ghosts().col(1) == Vec3(-0.5, 9.0, 1.0));
}

TEST_CASE("an atom that is nowhere or far away is an error that names it") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double wrong : {std::nan(""), infinity, -infinity, 1e300, 6e6, -6e6}) {
        for (int a = 0; a < 3; ++a) {
            State state = scattered(7, Box(Vec3(3.0, 4.0, 5.0)));
            state.reorder({6, 5, 4, 3, 2, 1, 0});
            state.write_positions()(a, 1) = wrong;
            CAPTURE(wrong, a);
            CHECK_THROWS_AS(state.wrap(), PhysicsError);
            CHECK_THROWS_WITH(state.wrap(), Catch::StartsWith(std::isfinite(wrong) ? "atom 6 has left its box by "
                                                                                   : "atom 6 was pushed out of the ") &&
                                                Catch::Contains("time step"));
        }
    }
    CHECK_THROWS_WITH(one_atom_at({1.0, -2e7, 5.0}).wrap(),
                      Catch::StartsWith("atom 1 has left its box by 2e+07 sigma: "));
    State state = one_atom_at({2.9e6, -3.9e6, 4.9e6});  // a little less than a million edges
    CHECK_NOTHROW(state.wrap());
    CHECK(state.image(0) == Eigen::Vector3i(966666, -975000, 980000));
}

TEST_CASE("reordering carries everything that belongs to an atom") {
    const Box box(Vec3(3.0, 4.0, 5.0));
    State state = scattered(50, box);
    const auto handle = state.register_vectors("previous");
    for (Index i = 0; i < state.count(); ++i) {
        state.registered(handle).col(i) = Vec3(7.0, static_cast<double>(i), -1.0);
    }
    state.mark_forces_current();
    const State before = state;
    std::vector<Index> order(50);
    std::iota(order.begin(), order.end(), Index{0});
    std::mt19937_64 generator(22);
    for (int repeat = 1; repeat <= 3; ++repeat) {  // orders must combine, not only work once
        std::shuffle(order.begin(), order.end(), generator);
        state.set_ghost_count(3);
        state.reorder(order);
        CHECK(state.order_version() == repeat);
        CHECK(state.ghost_count() == 0);
        const auto index = state.index_of();
        for (Index id = 0; id < state.count(); ++id) {
            const Index i = index[static_cast<std::size_t>(id)];
            CHECK(state.ids()[static_cast<std::size_t>(i)] == id);
            CHECK(state.positions().col(i) == before.positions().col(id));
            CHECK(state.velocities().col(i) == before.velocities().col(id));
            CHECK(state.forces().col(i) == before.forces().col(id));
            CHECK(state.masses()[static_cast<std::size_t>(i)] == before.masses()[static_cast<std::size_t>(id)]);
            CHECK(state.image(i) == before.image(id));
            CHECK(state.registered(handle).col(i) == before.registered(handle).col(id));
        }
    }
}

TEST_CASE("reordering takes atom order(k) of the old to place k") {
    State state(3);
    state.reorder({2, 0, 1});
    CHECK(state.ids() == std::vector<Index>{2, 0, 1});
    CHECK(state.index_of() == std::vector<Index>{1, 2, 0});
    state.reorder({2, 0, 1});
    CHECK(state.ids() == std::vector<Index>{1, 2, 0});
    CHECK_THROWS_AS(state.reorder({0, 1}), ContractViolation);
    CHECK_THROWS_AS(state.reorder({0, 1, 2, 3}), ContractViolation);
}

TEST_CASE("ghosts follow the local atoms and have positions only") {
    State state = scattered(4, Box(Vec3(3.0, 4.0, 5.0)));
    const Eigen::Matrix3Xd local = state.positions();
    state.set_ghost_count(2);
    CHECK(state.ghost_count() == 2);
    CHECK(state.write_ghosts().cols() == 2);
    state.write_ghosts().col(0) = Vec3(1.0, 2.0, 3.0);
    state.write_ghosts().col(1) = Vec3(4.0, 5.0, 6.0);
    CHECK(state.count() == 4);
    CHECK(state.positions() == local);
    CHECK(state.positions_and_ghosts().leftCols(4) == local);
    CHECK(state.positions_and_ghosts().col(4) == Vec3(1.0, 2.0, 3.0));
    CHECK(state.positions_and_ghosts().col(5) == Vec3(4.0, 5.0, 6.0));
    CHECK(state.velocities().cols() == 4);
    CHECK(state.forces().cols() == 4);
    state.set_ghost_count(0);
    CHECK(state.positions_and_ghosts() == local);
    CHECK_THROWS_AS(state.set_ghost_count(-1), ContractViolation);
    CHECK(state.ghost_count() == 0);
}

TEST_CASE("registered vectors start as zeros and are known by name") {
    State state(3);
    const auto a = state.register_vectors("a");
    const auto b = state.register_vectors("b");
    CHECK(a != b);
    CHECK(state.registered(a).cols() == 3);
    CHECK(state.registered(a).isZero(0.0));
    state.registered(a).col(2) = Vec3(1.0, 2.0, 3.0);
    CHECK(state.register_vectors("a") == a);
    CHECK(state.registered(a).col(2) == Vec3(1.0, 2.0, 3.0));
    CHECK(state.registered(b).isZero(0.0));
    CHECK_THROWS(state.registered(2));
}

TEST_CASE("a new box takes the atoms along") {
    const Box old_box(Vec3(3.0, 4.0, 5.0));
    const Box new_box(Vec3(4.5, 4.2, 3.3));
    State state = scattered(30, old_box);
    state.write_positions().col(0) = Vec3(7.5, -4.5, 14.5);  // far from the box, where its grid would be too coarse
    const auto before = state;
    state.set_ghost_count(5);
    state.rescale_to(new_box);
    CHECK(state.box().edges() == new_box.edges());
    CHECK(state.ghost_count() == 0);
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 r = state.positions().col(i);
        CHECK(r == new_box.snap(r));
        CHECK(r.minCoeff() >= 0.0);
        CHECK((new_box.edges() - r).minCoeff() >= 0.0);
        const Vec3 old_fraction = before.unwrapped(i).array() / old_box.edges().array();
        const Vec3 new_fraction = state.unwrapped(i).array() / new_box.edges().array();
        CHECK((old_fraction - new_fraction).cwiseAbs().maxCoeff() < 1e-14);
    }
    state.rescale_to(state.box());  // its own box
    CHECK(state.box().edges() == new_box.edges());
}

TEST_CASE("without a thermostat no heat has been given") {
    CHECK(State(3).heat() == 0.0);
}

namespace {

/// A state with everything that one can have.
State rich() {
    State state = scattered(9, Box(Vec3(5.0, 6.0, 7.0)));
    static_cast<void>(state.register_vectors("memory"));
    state.registered(0).col(4) = Vec3(1.0, 2.0, 3.0);
    state.reorder({8, 7, 6, 5, 4, 3, 2, 1, 0});
    state.time = 0.75;
    state.step = 12;
    state.bath = {-3.5, 0.25};
    return state;
}

void restore(State& state, const Archive& written) {
    Archive a(written.bytes());
    state.archive(a);
    a.expect_end();
}

}  // namespace

TEST_CASE("a state that was archived is the same in every bit, in memory order too") {
    State state = rich();
    Archive a;
    state.archive(a);
    State other(9, state.box());
    const auto order = other.order_version();
    restore(other, a);
    CHECK(other.positions() == state.positions());
    CHECK(other.velocities() == state.velocities());
    CHECK(other.forces() == state.forces());
    CHECK(other.masses() == state.masses());
    CHECK(other.ids() == state.ids());
    CHECK(std::as_const(other).registered(0) == std::as_const(state).registered(0));
    CHECK(other.register_vectors("memory") == 0);
    for (Index i = 0; i < 9; ++i) {
        CHECK(other.image(i) == state.image(i));
    }
    CHECK(other.time == 0.75);
    CHECK(other.step == 12);
    CHECK(other.bath == state.bath);
    CHECK(other.heat() == -3.5);
    CHECK(other.forces_are_current() == state.forces_are_current());
    CHECK(other.order_version() != order);

    Archive again;
    other.archive(again);
    CHECK(std::equal(again.bytes().begin(), again.bytes().end(), a.bytes().begin(), a.bytes().end()));
}

TEST_CASE("a state takes nothing from an archive of another kind of system, or of one that is not whole") {
    State state = rich();
    Archive a;
    state.archive(a);
    State unbounded(9);
    CHECK_THROWS_WITH(restore(unbounded, a), Catch::Contains("few bodies"));
    State larger(10, state.box());
    CHECK_THROWS_WITH(restore(larger, a), Catch::Contains("another number of atoms"));
    const Vec3 longer = state.box().edges() + Vec3(0.0, 0x1p-40, 0.0);
    State wider(9, Box(longer));
    CHECK_THROWS_WITH(restore(wider, a), Catch::Contains("its box differs from that of the run"));

    // Of two atoms of one id: ids stand where they are written, 8 bytes each.
    std::vector<std::byte> bytes(a.bytes().begin(), a.bytes().end());
    std::vector<std::byte> ids(9 * sizeof(Index));
    std::memcpy(ids.data(), state.ids().data(), ids.size());
    const auto at = std::search(bytes.begin(), bytes.end(), ids.begin(), ids.end());
    REQUIRE(at != bytes.end());
    *at = std::byte{0};
    State same(9, state.box());
    Archive twice(bytes);
    CHECK_THROWS_WITH(same.archive(twice), Catch::Contains("ids are not 0 to N - 1, each once"));
}

TEST_CASE("a state takes no image or number of steps that cannot be, and no fourth coordinate") {
    State good = rich();
    std::string why;
    SECTION("image") {
        good.set_image(3, {0, 1 << 30, 0});
        why = "too far from its box";
    }
    SECTION("step") {
        good.step = -1;
        why = "negative or too large";
    }
    SECTION("steps of a phase") {
        good.set_phase({"any", std::numeric_limits<Index>::max()});
        why = "negative or too large";
    }
    SECTION("padding") {
        *(good.write_velocities().data() + 7) = 1.0;
        why = "a fourth coordinate";
    }
    Archive a;
    good.archive(a);
    State state(9, good.box());
    Archive back(a.bytes());
    CHECK_THROWS_AS(state.archive(back), CheckpointError);
    Archive again(a.bytes());
    CHECK_THROWS_WITH(state.archive(again), Catch::Contains(why));
}

TEST_CASE("a kick is done with the forces and masses that were there, whoever changes them first") {
    const Box box(Vec3(3.0, 4.0, 5.0));
    const State start = scattered(300, box);
    constexpr double dt = 0.25;
    Eigen::Matrix3Xd expected = start.velocities();
    for (Index i = 0; i < start.count(); ++i) {
        expected.col(i) += dt / start.masses()[static_cast<std::size_t>(i)] * start.forces().col(i);
    }
    const auto after = [&](const auto& change) {
        State state = start;
        state.mark_forces_current();
        state.kick(dt);
        change(state);
        state.finish_kick();
        Eigen::Matrix3Xd v(3, state.count());
        for (Index i = 0; i < state.count(); ++i) {
            v.col(state.ids()[static_cast<std::size_t>(i)]) = static_cast<const State&>(state).velocities().col(i);
        }
        return v;
    };
    CHECK(after([](State&) {}) == expected);
    CHECK(after([](State& state) { state.write_forces().setZero(); }) == expected);
    CHECK(after([](State& state) { state.write_masses().assign(300, 1e9); }) == expected);
    CHECK(after([](State& state) { state.write_positions().setZero(); }) == expected);
    CHECK(after([&](State& state) { state.write_velocities() -= expected; }).norm() == 0.0);
    CHECK(after([&](State& state) { state.rescale_to(Box(2.0 * box.edges())); }) == expected);
    CHECK(after([](State& state) {
              std::vector<Index> order(300);
              std::iota(order.rbegin(), order.rend(), 0);
              state.reorder(order);
              state.write_forces().setZero();
          }) == expected);
    CHECK(after([](State& state) {
              std::vector<Index> order(300);
              std::iota(order.rbegin(), order.rend(), 0);
              state.write_positions().setZero();  // forces are stale, and stay where they are when atoms are reordered
              state.reorder(order);
          }) == expected);
    CHECK(after([](State& state) {
              const State copy = state;
              state = copy;
          }) == expected);
    CHECK(after([&](State& state) { state.kick(-dt); }).isApprox(start.velocities(), 1e-15));
}

TEST_CASE("velocities are not shown while a kick is pending") {
    State state = scattered(5, Box(Vec3(3.0, 4.0, 5.0)));
    state.mark_forces_current();
    state.kick(0.25);
    CHECK_THROWS_AS(static_cast<const State&>(state).velocities(), ContractViolation);
    const State copy = state;
    CHECK_THROWS_AS(copy.velocities(), ContractViolation);
    state.finish_kick();
    CHECK_NOTHROW(static_cast<const State&>(state).velocities());
    state.kick(0.0);
    CHECK_NOTHROW(static_cast<const State&>(state).velocities());
}

TEST_CASE("a kick that is taken over is not done") {
    State state = scattered(5, Box(Vec3(3.0, 4.0, 5.0)));
    const Eigen::Matrix3Xd before = static_cast<const State&>(state).velocities();
    state.mark_forces_current();
    CHECK(state.take_kick() == 0.0);
    state.set_phase({"leapfrog", 3});
    state.kick(0.25);
    CHECK(state.phase().integrator.empty());
    CHECK(state.take_kick() == 0.25);
    CHECK(state.take_kick() == 0.0);
    CHECK(static_cast<const State&>(state).velocities() == before);
}
