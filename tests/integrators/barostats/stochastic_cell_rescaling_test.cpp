#include <cmath>
#include <limits>
#include "catch.hpp"

#include "integrators/barostats/made_barostat.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

std::unique_ptr<Barostat> made(const PressureBath& bath, double pressure, double compressibility, Index every) {
    return test::made_barostat(
        "stochastic-cell-rescaling", bath,
        {{"pressure", pressure}, {"compressibility", compressibility}, {"time", 1.0}, {"every", std::int64_t{every}}});
}

VirialPressure evenly(double pressure) {
    return {pressure, Vec3::Constant(pressure)};
}

}  // namespace

TEST_CASE("positions are scaled as the box is, velocities stay, and forces become stale") {
    State state = test::atoms_in_box(20);
    state.mark_forces_current();
    const State before = state;
    const auto barostat = made({1.3, 0.005, 8, 1.0}, 0.5, 0.05, 10);
    barostat->apply(state, evenly(0.7));
    const Vec3 factors = state.box().edges().cwiseQuotient(before.box().edges());
    CHECK(factors[0] != 1.0);
    CHECK(factors[1] == Approx(factors[0]).epsilon(1e-14));
    CHECK(factors[2] == Approx(factors[0]).epsilon(1e-14));
    CHECK_FALSE(state.forces_are_current());
    const State& after = state;
    CHECK((after.positions() - factors[0] * before.positions()).norm() < 1e-13);
    CHECK(after.velocities() == before.velocities());
}

TEST_CASE("it acts at its schedule, and more strongly the rarer that is") {
    const auto rare = made({1e-12, 0.005, 8, 1.0}, 0.5, 0.05, 20);
    const auto often = made({1e-12, 0.005, 8, 1.0}, 0.5, 0.05, 10);
    CHECK(rare->due(20));
    CHECK_FALSE(rare->due(10));
    CHECK(often->due(10));
    State a = test::atoms_in_box(20);
    State b = test::atoms_in_box(20);
    const double volume = a.box().volume();
    rare->apply(a, evenly(0.7));
    often->apply(b, evenly(0.7));
    // dV = (beta V/tau_p) (p - p_0) n dt, without noise at T = 0
    CHECK(b.box().volume() / volume - 1.0 == Approx(0.05 * 0.2 * 0.05).epsilon(1e-3));
    CHECK(a.box().volume() / volume - 1.0 == Approx(2.0 * 0.05 * 0.2 * 0.05).epsilon(1e-3));
}

TEST_CASE("the volume of an ideal gas takes the distribution of the ensemble of constant pressure") {
    // V^N exp(-p_0 V/T): <V> = (N + 1) T/p_0, the variance is (N + 1) (T/p_0)^2, and <1/V> = p_0/(N T).
    constexpr Index atoms = 40;
    constexpr double wanted = 1.5;
    State state = test::atoms_in_box(atoms);
    const auto barostat = made({1.3, 0.01, 8, 0.1}, wanted, 0.3, 1);
    double sum = 0.0;
    double density = 0.0;
    double squares = 0.0;
    constexpr Index steps = 2000000;  // 9000 relaxation times
    for (Index step = 1; step <= steps; ++step) {
        state.step = step;
        barostat->apply(state, evenly(0.0));  // there is no virial
        sum += state.box().volume();
        density += atoms / state.box().volume() / steps;
        squares += state.box().volume() * state.box().volume();
    }
    const double mean = sum / steps;
    const double variance = squares / steps - mean * mean;
    const double scale = 1.3 / wanted;
    CHECK(mean == Approx((atoms + 1) * scale).epsilon(0.01));
    CHECK(density == Approx(1.0 / scale).epsilon(0.01));
    CHECK(variance == Approx((atoms + 1) * scale * scale).epsilon(0.12));
}

TEST_CASE("the noise is the same for the same seed and step, and another for others") {
    const auto volume_after = [](std::uint64_t seed, Index step) {
        State state = test::atoms_in_box(20);
        state.step = step;
        made({1.3, 0.005, seed, 1.0}, 0.5, 0.05, 10)->apply(state, evenly(0.5));
        return state.box().volume();
    };
    CHECK(volume_after(1, 10) == volume_after(1, 10));
    CHECK(volume_after(1, 10) != volume_after(2, 10));
    CHECK(volume_after(1, 10) != volume_after(1, 20));
}

TEST_CASE("a pressure far from the wanted one, nonsense, and a box that becomes too small end the run") {
    State state = test::atoms_in_box(20);
    const Vec3 edges = state.box().edges();
    const auto barostat = made({1.3, 0.005, 8, 1.0}, 0.5, 0.05, 10);
    for (const double pressure : {100.0, -100.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_AS(barostat->apply(state, evenly(pressure)), PhysicsError);
    }
    CHECK_THROWS_WITH(barostat->apply(state, evenly(100.0)), Catch::Contains("the pressure is 100.217, not 0.5"));
    CHECK_THROWS_WITH(made({1.3, 0.005, 8, 4.5}, 0.5, 0.05, 10)->apply(state, evenly(0.5)),
                      Catch::Contains("less than two cutoffs"));
    CHECK(state.box().edges() == edges);
}
