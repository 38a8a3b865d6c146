#include "model/velocities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

/// Masses 1, 4, 39.948, 1, 4, ... by id.
State mixture(Index atoms) {
    State state(atoms);
    constexpr double masses[] = {1.0, 4.0, 39.948};
    for (std::size_t i = 0; i < static_cast<std::size_t>(atoms); ++i) {
        state.write_masses()[i] = masses[i % 3];
    }
    return state;
}

double largest_momentum(const State& state) {
    return total_momentum(state).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("degrees of freedom: three an atom, less the three of the total momentum") {
    CHECK(degrees_of_freedom(0) == 0);
    CHECK(degrees_of_freedom(1) == 0);
    CHECK(degrees_of_freedom(2) == 3);
    CHECK(degrees_of_freedom(864) == 2589);
    CHECK(degrees_of_freedom(Index{1} << 33) == 3 * (Index{1} << 33) - 3);
}

TEST_CASE("kinetic energy, temperature and momentum of known velocities") {
    State state(3);
    state.write_masses() = {1.0, 2.0, 0.5};
    state.write_velocities() << 1.0, 0.0, 2.0,  // x of the three atoms
        2.0, -1.0, 0.0,                         // y
        2.0, 3.0, 4.0;                          // z
    CHECK(kinetic_energy(state) == 0.5 * (9.0 + 2.0 * 10.0 + 0.5 * 20.0));
    // Of the motion about the centre of mass: P^2/M = 104/3.5 is not of it.
    CHECK(*temperature(state) == Approx((2.0 * 19.5 - 104.0 / 3.5) / 6.0).epsilon(1e-15));
    CHECK(total_momentum(state) == Vec3(2.0, 0.0, 10.0));
    CHECK(kinetic_energy(State(0)) == 0.0);
    CHECK(total_momentum(State(0)) == Vec3::Zero());
    CHECK_FALSE(temperature(State(0)).has_value());
    CHECK_FALSE(temperature(State(1)).has_value());
    CHECK(*temperature(State(2)) == 0.0);
}

TEST_CASE("the motion of the centre of mass is no heat") {
    State state = mixture(50);
    draw_velocities(state, 0.5, 3);
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        v.col(i) += Vec3(1.0, -2.0, 0.5);
    }
    CHECK(*temperature(state) == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("drawn velocities have exactly the temperature and no momentum") {
    for (const Index atoms : {2, 3, 17, 864}) {
        for (const double target : {1e-6, 0.722, 2.889, 100.0}) {
            for (const bool unequal : {false, true}) {
                State state = unequal ? mixture(atoms) : State(atoms);
                draw_velocities(state, target, 1967);
                CAPTURE(atoms, target, unequal);
                CHECK(*temperature(state) == Approx(target).epsilon(1e-14));
                CHECK(largest_momentum(state) < 1e-12 * std::sqrt(target));
            }
        }
    }
}

TEST_CASE("one atom, no atom and T = 0 are left at rest") {
    for (const double mass : {1.0, 0.1, 3.7, 39.948}) {
        State state(1);
        state.write_masses()[0] = mass;
        state.write_velocities().setOnes();
        draw_velocities(state, 1.3, 7);
        CHECK(state.velocities().isZero(0.0));
    }
    State none(0);
    draw_velocities(none, 1.0, 7);
    CHECK(none.count() == 0);
    State cold = mixture(10);
    cold.write_velocities().setOnes();
    draw_velocities(cold, 0.0, 7);
    CHECK(cold.velocities().isZero(0.0));
    CHECK_FALSE(cold.velocities().array().unaryExpr([](double v) { return std::signbit(v); }).any());
}

TEST_CASE("drawn velocities are those of Maxwell and Boltzmann, mass by mass") {
    constexpr Index atoms = 60000;
    constexpr double target = 0.722;
    State state = mixture(atoms);
    draw_velocities(state, target, 11);
    for (std::size_t kind = 0; kind < 3; ++kind) {
        for (int a = 0; a < 3; ++a) {
            std::vector<double> v;
            for (std::size_t i = kind; i < static_cast<std::size_t>(atoms); i += 3) {
                v.push_back(state.velocities()(a, static_cast<Index>(i)) * std::sqrt(state.masses()[i] / target));
            }
            std::sort(v.begin(), v.end());
            const auto n = static_cast<double>(v.size());
            double largest = 0.0;  // Kolmogorov and Smirnov's distance to the normal distribution
            for (std::size_t k = 0; k < v.size(); ++k) {
                const double f = 0.5 * std::erfc(-v[k] / std::numbers::sqrt2);
                const auto below = static_cast<double>(k);
                largest = std::max({largest, f - below / n, (below + 1.0) / n - f});
            }
            CAPTURE(kind, a);
            CHECK(largest * std::sqrt(n) < 1.63);  // 99 % of samples
            const double mean_square = std::inner_product(v.begin(), v.end(), v.begin(), 0.0) / n;
            CHECK(mean_square == Approx(1.0).margin(3.5 * std::sqrt(2.0 / n)));
        }
    }
}

TEST_CASE("an atom's velocity belongs to its id, wherever it lies in memory") {
    State in_order = mixture(300);
    State shuffled = in_order;
    std::vector<Index> order(300);
    std::iota(order.begin(), order.end(), Index{0});
    std::mt19937_64 generator(31);
    std::shuffle(order.begin(), order.end(), generator);
    shuffled.reorder(order);
    draw_velocities(in_order, 0.722, 5);
    draw_velocities(shuffled, 0.722, 5);
    const auto index = shuffled.index_of();
    double largest = 0.0;
    for (Index id = 0; id < 300; ++id) {
        const Vec3 v = shuffled.velocities().col(index[static_cast<std::size_t>(id)]);
        largest = std::max(largest, (v - in_order.velocities().col(id)).cwiseAbs().maxCoeff());
    }
    CHECK(largest < 1e-14);  // the sums that remove momentum and set T round in another order

    State again = mixture(300);
    State other = mixture(300);
    draw_velocities(again, 0.722, 5);
    draw_velocities(other, 0.722, 6);
    CHECK(again.velocities() == in_order.velocities());
    CHECK((again.velocities() - other.velocities()).cwiseAbs().minCoeff() > 0.0);
}

TEST_CASE("removing momentum subtracts one velocity from all") {
    State state = mixture(50);
    draw_velocities(state, 1.0, 3);
    const Eigen::Matrix3Xd before = state.velocities();
    const Vec3 drift(10.0, -20.0, 0.5);
    state.write_velocities().colwise() += drift;
    CHECK(largest_momentum(state) > 1000.0);
    remove_momentum(state);
    CHECK(largest_momentum(state) < 1e-11);
    CHECK((state.velocities() - before).cwiseAbs().maxCoeff() < 1e-13);
    State none(0);
    CHECK_NOTHROW(remove_momentum(none));
}

TEST_CASE("rescaling multiplies all velocities by sqrt(target / T)") {
    State state = mixture(50);
    draw_velocities(state, 0.5, 3);
    const Eigen::Matrix3Xd before = state.velocities();
    rescale_velocities(state, 2.0);
    CHECK(*temperature(state) == Approx(2.0).epsilon(1e-14));
    CHECK((state.velocities() - 2.0 * before).cwiseAbs().maxCoeff() < 1e-14 * before.cwiseAbs().maxCoeff());
    rescale_velocities(state, 0.0);
    CHECK(state.velocities().isZero(0.0));
    rescale_velocities(state, 1.0);  // at rest: nothing to scale
    CHECK(state.velocities().isZero(0.0));
    State one(1);
    one.write_velocities().setOnes();
    rescale_velocities(one, 1.0);  // has no temperature
    CHECK(one.velocities() == Eigen::Matrix3Xd::Ones(3, 1));
}
