#include "model/checksum.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/model/lattice.hpp"

using namespace ljmd;

namespace {

/// 108 atoms on the grid of their box, moved a little off their lattice, some of them outside.
State fluid() {
    const Box box(Vec3(5.0, 5.5, 6.0));
    State state(108, box);
    const auto sites = lattice_sites(Lattice::fcc, 3, box);
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        const double k = static_cast<double>(i);
        r.col(i) = box.snap(sites[static_cast<std::size_t>(i)] +
                            Vec3(std::sin(k), std::cos(3.0 * k), -0.9 * std::sin(5.0 * k)));
    }
    return state;
}

State bodies() {
    State state(3);
    state.write_positions() << 1.0, 0.1, -2.0,  //
        0.0, 3.0, 1e-3,                         //
        0.5, -1.0, 2.0;
    return state;
}

std::vector<Index> shuffled(Index count, Index stride) {
    std::vector<Index> order;
    for (Index k = 0; k < count; ++k) {
        order.push_back((stride * k + 1) % count);
    }
    return order;
}

double one_bit_more(double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
}

}  // namespace

TEST_CASE("a checksum does not depend on the order of atoms in memory, nor on when they were wrapped") {
    const State start = fluid();
    const std::string expected = checksum(start);
    CHECK(expected.size() == std::string("xxh3:0123456789abcdef").size());
    CHECK(expected.substr(0, 5) == "xxh3:");
    State state = start;
    state.wrap();
    CHECK(static_cast<const State&>(state).positions() != start.positions());
    CHECK(checksum(state) == expected);
    state.reorder(shuffled(108, 7));
    CHECK(checksum(state) == expected);
    State few = bodies();
    few.reorder({2, 0, 1});
    CHECK(checksum(few) == checksum(bodies()));
}

TEST_CASE("a checksum changes with one bit of one coordinate, and with the number of edges crossed") {
    const State start = bodies();
    for (Index i = 0; i < 3; ++i) {
        for (Index a = 0; a < 3; ++a) {
            State state = start;
            const double x = start.positions()(a, i);
            state.write_positions()(a, i) = x == 0.0 ? std::numeric_limits<double>::denorm_min() : one_bit_more(x);
            CHECK(checksum(state) != checksum(start));
        }
    }
    State moved = fluid();
    moved.set_image(5, Eigen::Vector3i(0, 1, 0));
    CHECK(checksum(moved) != checksum(fluid()));
}

TEST_CASE("a checksum tells which atom is where, and nothing of velocities and time") {
    State swapped = bodies();
    swapped.write_positions().col(0).swap(swapped.write_positions().col(1));
    CHECK(checksum(swapped) != checksum(bodies()));
    State later = bodies();
    later.write_velocities().setOnes();
    later.time = 3.0;
    later.step = 17;
    CHECK(checksum(later) == checksum(bodies()));
}

TEST_CASE("the checksum of a configuration changes with whatever was read") {
    const Configuration whole{.edges = Vec3(5, 6, 7),
                              .positions = {Vec3(1, 2, 3), Vec3(2, 3, 4)},
                              .velocities = {Vec3(0.1, 0.2, 0.3), Vec3(0, 0, 1)},
                              .masses = {1.0, 1.0},
                              .time = 2.0,
                              .step = 10};
    const std::string expected = checksum(whole);
    CHECK(checksum(Configuration(whole)) == expected);
    const auto changed = [&](const auto& change) {
        Configuration other = whole;
        change(other);
        return checksum(other) != expected;
    };
    CHECK(changed([](Configuration& c) { c.edges[2] = one_bit_more(c.edges[2]); }));
    CHECK(changed([](Configuration& c) { c.positions[1][0] = one_bit_more(c.positions[1][0]); }));
    CHECK(changed([](Configuration& c) { std::swap(c.positions[0], c.positions[1]); }));
    CHECK(changed([](Configuration& c) { c.velocities[0][1] = one_bit_more(c.velocities[0][1]); }));
    CHECK(changed([](Configuration& c) { c.velocities.clear(); }));
    CHECK(changed([](Configuration& c) { c.masses[0] = 2.0; }));
    CHECK(changed([](Configuration& c) { c.time = 2.5; }));
    CHECK(changed([](Configuration& c) { c.step = 11; }));
    CHECK(changed([](Configuration& c) { std::swap(c.positions, c.velocities); }));
}

TEST_CASE("zero is zero whatever its sign, and what is not finite has no checksum") {
    State state = bodies();
    state.write_positions()(1, 0) = -0.0;
    CHECK(checksum(state) == checksum(bodies()));
    for (State bad : {bodies(), fluid()}) {
        bad.write_positions()(2, 1) = std::nan("");
        CHECK_THROWS_AS(checksum(bad), PhysicsError);
    }
}
