#include <cmath>
#include <limits>
#include "catch.hpp"

#include "integrators/barostats/made_barostat.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

std::unique_ptr<Barostat> made_for_edges(const PressureBath& bath, const std::string& edges, double pressure,
                                         double compressibility, Index every) {
    return test::made_barostat("anisotropic-cell-rescaling", bath,
                               {{"pressure", pressure},
                                {"edges", edges},
                                {"compressibility", compressibility},
                                {"time", 1.0},
                                {"every", std::int64_t{every}}});
}

VirialPressure along(const Vec3& pressures) {
    return {pressures.mean(), pressures};
}

Vec3 logarithms(const State& state) {
    return state.box().edges().array().log();
}

}  // namespace

TEST_CASE("each edge follows the pressure along it, and positions follow the edges") {
    State state = test::atoms_in_box(20);
    state.mark_forces_current();
    const State before = state;
    // dx_a = (beta/3 tau_p) (p_aa - p_0) n dt, without noise at T = 0
    made_for_edges({1e-12, 0.005, 8, 1.0}, "xyz", 0.5, 0.06, 10)->apply(state, along({0.7, 0.5, 0.2}));
    const Vec3 change = logarithms(state) - logarithms(before);
    CHECK(change[0] == Approx(0.02 * 0.2 * 0.05).epsilon(1e-3));
    CHECK(std::abs(change[1]) < 1e-8);
    CHECK(change[2] == Approx(-0.02 * 0.3 * 0.05).epsilon(1e-3));
    CHECK_FALSE(state.forces_are_current());
    const State& after = state;
    const Vec3 factors = after.box().edges().cwiseQuotient(before.box().edges());
    CHECK((after.positions() - factors.asDiagonal() * before.positions()).norm() < 1e-13);
    CHECK(after.velocities() == before.velocities());
}

TEST_CASE("edges that are not named keep their lengths, to the last bit") {
    const std::string edges = GENERATE("xyz", "xy", "xz", "yz", "x", "y", "z");
    State state = test::atoms_in_box(20);
    const Vec3 before = state.box().edges();
    made_for_edges({1.3, 0.005, 8, 1.0}, edges, 0.5, 0.06, 10)->apply(state, along({0.7, 0.8, 0.9}));
    for (const Index a : {0, 1, 2}) {
        CAPTURE(edges, a);
        CHECK((state.box().edges()[a] != before[a]) == (edges.find("xyz"[a]) != std::string::npos));
    }
}

TEST_CASE("volume and shape of an elastic ideal gas take the distribution of the ensemble of constant pressure") {
    // With U = (k/2) sum_a (x_a - mean x)^2, x_a = ln L_a, the volume has V^N exp(-p_0 V/T) dV whatever the shape, so
    // that <V> = (N + 1) T/p_0 with the variance (N + 1) (T/p_0)^2, and the shape has two modes of <(x_a - mean x)^2> =
    // T/k. With one free edge the box has no shape of its own, and k = 0.
    const bool all = GENERATE(true, false);
    constexpr Index atoms = 40;
    constexpr double wanted = 1.5;
    const double stiffness = all ? 60.0 : 0.0;
    State state = test::atoms_in_box(atoms);
    const auto barostat = made_for_edges({1.3, 0.01, 8, 0.1}, all ? "xyz" : "y", wanted, all ? 0.3 : 0.9, 1);
    const Vec3 at_first = logarithms(state);
    double sum = 0.0;
    double squares = 0.0;
    double shape = 0.0;
    constexpr Index steps = 2000000;  // 9000 relaxation times
    for (Index step = 1; step <= steps; ++step) {
        state.step = step;
        const double volume = state.box().volume();
        const Vec3 strain = (logarithms(state) - at_first).array() - (logarithms(state) - at_first).mean();
        barostat->apply(state, along(-stiffness / volume * strain));
        sum += volume;
        squares += volume * volume;
        shape += strain.squaredNorm();
    }
    const double mean = sum / steps;
    const double variance = squares / steps - mean * mean;
    const double scale = 1.3 / wanted;
    CHECK(mean == Approx((atoms + 1) * scale).epsilon(0.01));
    CHECK(variance == Approx((atoms + 1) * scale * scale).epsilon(0.12));
    if (all) {
        CHECK(shape / steps == Approx(2.0 * 1.3 / stiffness).epsilon(0.05));
    }
}

TEST_CASE("a pressure far from the wanted one, nonsense, and an edge that becomes too short end the run") {
    State state = test::atoms_in_box(20);
    const Vec3 edges = state.box().edges();
    const auto barostat = made_for_edges({1.3, 0.005, 8, 1.0}, "xyz", 0.5, 0.05, 10);
    for (const double pressure : {200.0, -200.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_AS(barostat->apply(state, along({0.5, pressure, 0.5})), PhysicsError);
    }
    CHECK_THROWS_WITH(barostat->apply(state, along({0.5, 200.0, 0.5})), Catch::Contains("0.716667, 200.217 and"));
    CHECK_THROWS_WITH(made_for_edges({1.3, 0.005, 8, 4.5}, "xyz", 0.5, 0.05, 10)->apply(state, along({0.5, 0.5, 0.5})),
                      Catch::Contains("less than two cutoffs"));
    CHECK(state.box().edges() == edges);
}
