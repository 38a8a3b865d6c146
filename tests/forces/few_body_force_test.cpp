#include "forces/few_body_force.hpp"

#include <algorithm>
#include <limits>
#include "catch.hpp"

#include "forces/made_few_body_force.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"

using namespace ljmd;

namespace {

/// Every key of a method with a number of its own that all ranges allow; without those that have a default if wanted.
test::Numbers numbers_for(const FewBodyForceMethod& method, bool with_defaulted) {
    test::Numbers numbers;
    double value = 0.7;
    for (const Key& key : keys_of(method)) {
        if (key.required || with_defaulted) {
            numbers.emplace_back(key.name, value);
        }
        value += 0.4;
    }
    return numbers;
}

/// Four bodies of different masses that every method accepts, in as many dimensions as it takes.
State scattered(const FewBodyForceMethod& method) {
    std::vector<Vec3> positions = {{0.8, 0.3, -0.4}, {1.7, -0.9, 0.2}, {0.5, 1.1, 0.9}, {2.6, 0.4, -1.3}};
    for (Vec3& r : positions) {
        r.tail(3 - method.max_dimensions).setZero();
    }
    return test::bodies_at(positions, {1.0, 2.5, 0.3, 4.0});
}

double energy(ForceField& force, State& state) {
    return force.evaluate(state, Request::forces_and_energy).potential_energy;
}

/// Calls `look(method, force)` for every method, with defaults and without.
template <class Look>
void for_every_force(const Look& look) {
    for (const auto& method : all_few_body_forces()) {
        for (const bool with_defaulted : {false, true}) {
            CAPTURE(method.name, with_defaulted);
            const auto force = test::made_few_body_force(method.name, numbers_for(method, with_defaulted));
            look(method, *force);
        }
    }
}

}  // namespace

TEST_CASE("few-body forces are listed by name, in alphabetical order, with what they mean") {
    const auto methods = all_few_body_forces();
    const std::vector<std::string> names = plugin_names(methods);
    CHECK(std::ranges::is_sorted(names));
    const std::vector<std::string> at_least{"harmonic", "newtonian-gravity", "pendulum", "radial-kepler"};
    CHECK(std::ranges::includes(names, at_least));
    for (const auto& method : methods) {
        CAPTURE(method.name);
        CHECK_FALSE(method.meaning.empty());
        CHECK(find_few_body_force(method.name).name == method.name);
        CHECK(method.min_dimensions == 1);
        CHECK((method.max_dimensions == 1 || method.max_dimensions == 3));
        for (const Key& key : keys_of(method)) {
            CAPTURE(key.name);
            CHECK_FALSE(key.meaning_text.empty());
            CHECK_FALSE(key.reduced_unit.empty());
        }
    }
    CHECK_THROWS_AS(find_few_body_force("aether"), InputError);
    CHECK_THROWS_WITH(find_few_body_force("aether"), Catch::Contains("few-body force") && Catch::Contains("pendulum"));
}

TEST_CASE("every few-body force is minus the gradient of its energy") {
    for_every_force([](const FewBodyForceMethod& method, ForceField& force) {
        State state = scattered(method);
        force.evaluate(state, Request::forces);
        CHECK(state.forces_are_current());
        const Eigen::Matrix3Xd f = static_cast<const State&>(state).forces();
        const double h = 1e-5;
        for (Index i = 0; i < state.count(); ++i) {
            for (int a = 0; a < method.max_dimensions; ++a) {
                CAPTURE(i, a);
                const double here = static_cast<const State&>(state).positions()(a, i);
                state.write_positions()(a, i) = here + h;
                const double up = energy(force, state);
                state.write_positions()(a, i) = here - h;
                const double down = energy(force, state);
                state.write_positions()(a, i) = here;
                CHECK(f(a, i) == Approx((down - up) / (2.0 * h)).epsilon(1e-7).margin(1e-7 * f.norm()));
                CHECK(f(a, i) != 0.0);
            }
        }
        CHECK(f.bottomRows(3 - method.max_dimensions).isZero(0.0));
    });
}

TEST_CASE("every few-body force gives the virial, sum of r f, and nothing but forces when only they are wanted") {
    for_every_force([](const FewBodyForceMethod& method, ForceField& force) {
        State state = scattered(method);
        const Evaluation all = force.evaluate(state, Request::forces_and_energy);
        const Eigen::Matrix3Xd f = static_cast<const State&>(state).forces();
        const Mat3 expected = static_cast<const State&>(state).positions() * f.transpose();
        CHECK((all.virial - expected).norm() < 1e-13 * expected.norm());
        CHECK(all.potential_energy != 0.0);

        const Evaluation none = force.evaluate(state, Request::forces);
        CHECK(none.potential_energy == 0.0);
        CHECK(none.virial.isZero(0.0));
        CHECK(static_cast<const State&>(state).forces() == f);
    });
}

TEST_CASE("no few-body force depends on the order of the bodies in memory, to the last bit") {
    for_every_force([](const FewBodyForceMethod& method, ForceField& force) {
        State state = scattered(method);
        const Evaluation before = force.evaluate(state, Request::forces_and_energy);
        const Eigen::Matrix3Xd f = static_cast<const State&>(state).forces();
        state.reorder({2, 0, 3, 1});
        const Evaluation after = force.evaluate(state, Request::forces_and_energy);
        CHECK(after.potential_energy == before.potential_energy);
        CHECK(after.virial == before.virial);
        for (Index i = 0; i < state.count(); ++i) {
            CHECK(static_cast<const State&>(state).forces().col(i) == f.col(state.ids()[static_cast<std::size_t>(i)]));
        }
    });
}

TEST_CASE("every few-body force wants every number that has no default") {
    for (const auto& method : all_few_body_forces()) {
        const test::Numbers numbers = numbers_for(method, false);
        CHECK_FALSE(numbers.empty());
        for (std::size_t left_out = 0; left_out < numbers.size(); ++left_out) {
            CAPTURE(method.name, numbers[left_out].first);
            test::Numbers fewer = numbers;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
            CHECK_THROWS_WITH(test::few_body_section(method.name, fewer), Catch::Contains(numbers[left_out].first));
            fewer.emplace_back(numbers[left_out].first, -1.0);
            CHECK_THROWS_AS(test::few_body_section(method.name, fewer), InputError);
        }
    }
}

TEST_CASE("every few-body force accepts a sound start and names the body whose position is not finite in a run") {
    for_every_force([](const FewBodyForceMethod& method, ForceField& force) {
        for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            State state = scattered(method);
            CHECK_FALSE(test::problem_at_start(method.name, numbers_for(method, true), state));
            state.reorder({3, 2, 1, 0});
            state.write_positions()(0, 1) = wrong;
            CHECK_THROWS_AS(force.evaluate(state, Request::forces), PhysicsError);
            CHECK_THROWS_WITH(force.evaluate(state, Request::forces), Catch::Contains("body 3 "));
            CHECK_FALSE(state.forces_are_current());
        }
    });
}
