#include "compare/agreement.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "compare/small_fluid.hpp"
#include "ljmd/model/box.hpp"

using namespace ljmd;

TEST_CASE("a check passes up to its tolerance, and never without a number") {
    CHECK(Check{"x", 1.0, 1.0}.passed());
    CHECK(Check{"x", 0.0, 0.0}.passed());
    CHECK_FALSE(Check{"x", std::nextafter(1.0, 2.0), 1.0}.passed());
    CHECK_FALSE(Check{"x", std::numeric_limits<double>::quiet_NaN(), 1.0}.passed());
    CHECK_FALSE(Check{"x", std::numeric_limits<double>::infinity(), 1.0}.passed());
}

TEST_CASE("what is not a number is not lost among distances") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(larger_or_nan(1.0, 2.0) == 2.0);
    CHECK(larger_or_nan(2.0, 1.0) == 2.0);
    CHECK(std::isnan(larger_or_nan(nan, 1.0)));
    CHECK(std::isnan(larger_or_nan(1.0, nan)));
    CHECK(relative_difference(1.5, -1.0) == 2.5);
    CHECK(relative_difference(0.25, 0.0) == 0.25);
}

TEST_CASE("a step is judged by the next limit that is not before it, and not at all beyond the last") {
    const std::vector<Agreement::Limit> limits{{1, 1e-14}, {10, 5e-13}, {100, 1e-11}};
    CHECK(limit_at(limits, 1) == 1e-14);
    CHECK(limit_at(limits, 2) == 5e-13);
    CHECK(limit_at(limits, 10) == 5e-13);
    CHECK(limit_at(limits, 100) == 1e-11);
    CHECK_FALSE(limit_at(limits, 101));
    CHECK_FALSE(limit_at({}, 1));
}

TEST_CASE("distances may be larger where they have longer to grow, coarser numbers or more atoms") {
    const auto limit = [](const Situation& situation, Index step) {
        return limit_at(double_agreement(situation).positions, step).value();
    };
    CHECK(limit({}, 1) == 1e-14);
    CHECK(limit({}, 500) == 5e-9);
    CHECK(limit({.time_step = 0.005}, 500) == Approx(5e-9 * std::exp(3.75 / 2.0)));
    CHECK(limit({.time_step = 0.001}, 500) == 5e-9);
    CHECK(limit({.longest_edge = 32.0}, 1) == 2e-14);
    CHECK(limit({.atoms = 8640}, 500) == Approx(5e-8));
    CHECK(limit({.atoms = 8640}, 200) == 5e-11);
    CHECK(limit({.atoms = 2}, 500) == 5e-9);
}

TEST_CASE("in large boxes separations are coarser: all that is made of them may differ more") {
    const Agreement usual = double_agreement({});
    for (const double edge : {32.0, 50.0, 500.0}) {
        const Agreement large = double_agreement({.longest_edge = edge});
        CHECK(large.energy == Approx(usual.energy * edge / 16.0));
        CHECK(large.largest_force == Approx(usual.largest_force * edge / 16.0));
        CHECK(large.rms_force == Approx(usual.rms_force * edge / 16.0));
        CHECK(large.pressure == Approx(usual.pressure * edge / 16.0));
        CHECK(large.kinetic_energy >= usual.kinetic_energy * edge / 16.0);
        CHECK(lammps_agreement({.longest_edge = edge}).energy == Approx(10.0 * large.energy));
    }
    CHECK(double_agreement({.longest_edge = 5.0}).energy == usual.energy);
}

TEST_CASE(
    "the kinetic energy may differ by the rounding of places over the time step, and by what distances make of it") {
    const auto limit = [](const Situation& situation) { return double_agreement(situation).kinetic_energy; };
    CHECK(limit({}) == Approx(1.05e-12).epsilon(0.01));
    // Velocities (r' - r)/dt of numbers around the edge, each off by half of the last place, in the worst case all
    // alike.
    for (const double edge : {10.0, 16.0, 17.0, 50.0, 64.0, 500.0}) {
        for (const double dt : {0.0005, 0.002}) {
            for (const double temperature : {0.1, 1.0}) {
                INFO(edge << " " << dt << " " << temperature);
                const double last_place = edge - std::nextafter(edge, 0.0);
                const double rounding = 2.0 * last_place / dt / std::sqrt(temperature);
                CHECK(rounding <= limit({temperature, dt, edge, 1000000}) * (1.0 + 1e-12));
                CHECK(limit({temperature, dt, edge, 1000000}) <= std::max(2.0 * rounding, 1e-12 * edge / 16.0 + 1e-12));
            }
        }
    }
    // What two atoms in a box of 50 sigma were found apart with a step of 0.002: 1.4e-12.
    CHECK(limit({.temperature = 1.0, .time_step = 0.002, .longest_edge = 50.0, .atoms = 2}) > 3e-12);
    CHECK(limit({.atoms = 216}) == Approx(2e-12));
    CHECK(limit({.time_step = 0.005, .atoms = 54}) == Approx(4e-12 * std::exp(0.375)));
    CHECK(std::isinf(limit({.temperature = 0.0})));
}

TEST_CASE("after one step in the same order nothing but two roundings may be between two places") {
    const auto first = [](double edge) {
        return limit_at(double_agreement({.longest_edge = edge}).positions_in_the_same_order, 1).value();
    };
    // (g + u)/2 in each direction: g the grid of the box, u the last place of the largest coordinate.
    const auto rounding = [](double edge) {
        const double last_place = std::nextafter(edge, 100.0) - edge;
        return 0.5 * std::sqrt(3.0) * (Box(Vec3::Constant(edge)).resolution() + last_place);
    };
    CHECK(first(10.08) == 5e-15);
    CHECK(first(5.0) == 5e-15);
    CHECK(first(16.8) == 1e-14);
    for (const double edge : {8.5, 10.08, 10.8, 16.8, 22.0, 33.6}) {
        INFO(edge);
        CHECK(rounding(edge) < first(edge));
        CHECK(first(edge) < 2.0 * rounding(edge));
    }
}

TEST_CASE("in the same order later steps, too, may be as much further apart as the grid is coarser") {
    const auto later = [](double edge, Index step) {
        return limit_at(double_agreement({.longest_edge = edge}).positions_in_the_same_order, step).value();
    };
    CHECK(later(10.08, 100) == 2e-13);
    CHECK(later(10.08, 500) == 1e-10);
    CHECK(later(16.8, 100) == 4e-13);
    CHECK(later(16.8, 500) == 2e-10);
    CHECK(later(33.6, 100) == 8e-13);
}

TEST_CASE("hot fluids are judged up to step 200, single precision is not judged by the limits of double") {
    const Situation hot{.temperature = 2.889};
    CHECK(limit_at(double_agreement({}).positions, 500));
    CHECK_FALSE(limit_at(double_agreement({}).positions, 501));
    CHECK(limit_at(double_agreement(hot).positions, 200));
    CHECK_FALSE(limit_at(double_agreement(hot).positions, 201));
    CHECK(single_agreement({}).energy > 1e6 * double_agreement({}).energy);
    CHECK(limit_at(single_agreement({}).positions, 100) > limit_at(double_agreement({}).positions, 100));
}

TEST_CASE("a situation is read off a fluid") {
    Fluid fluid = test::small_fluid();
    const Situation situation = situation_of(fluid, 0.002);
    CHECK(situation.atoms == 3);
    CHECK(situation.longest_edge == 8.0);
    CHECK(situation.time_step == 0.002);
    CHECK(situation.temperature == Approx(2.0 * kinetic_energy(fluid) / 6.0));
}
