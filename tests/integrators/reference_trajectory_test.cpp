#include "integrators/reference_trajectory.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include "catch.hpp"

#include "forces/made_few_body_force.hpp"
#include "integrators/three_bodies.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

constexpr double tight = 1e-13;

const double pi = std::acos(-1.0);

double distance(const State& state, Index i, Index j) {
    return (state.positions().col(i) - state.positions().col(j)).norm();
}

/// Largest difference of positions and velocities.
double difference(const State& one, const State& other) {
    return std::max((one.positions() - other.positions()).cwiseAbs().maxCoeff(),
                    (one.velocities() - other.velocities()).cwiseAbs().maxCoeff());
}

/// Largest difference of x and y from what is expected: `axes[a][i]`.
double difference(const State& state, const std::vector<std::vector<double>>& axes) {
    double largest = 0.0;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        for (std::size_t i = 0; i < axes[a].size(); ++i) {
            const double found = state.positions()(static_cast<Index>(a), static_cast<Index>(i));
            largest = std::max(largest, std::abs(found - axes[a][i]));
        }
    }
    return largest;
}

struct Invariants {
    double energy;
    double angular_momentum;  ///< its z component
    Vec3 momentum;
};

Invariants invariants(State state, ForceField& force) {
    Invariants result{force.evaluate(state, Request::forces_and_energy).potential_energy, 0.0, Vec3::Zero()};
    const State& now = state;
    for (Index i = 0; i < now.count(); ++i) {
        const double m = now.masses()[static_cast<std::size_t>(i)];
        const Vec3 r = now.positions().col(i);
        const Vec3 v = now.velocities().col(i);
        result.energy += 0.5 * m * v.squaredNorm();
        result.angular_momentum += m * (r.x() * v.y() - r.y() * v.x());
        result.momentum += m * v;
    }
    return result;
}

std::unique_ptr<ForceField> unit_gravity() {
    return test::made_few_body_force("newtonian-gravity", {{"gravitational_constant", 1.0}});
}

/// A body on the ellipse of mu = 1.001 that begins at its pericentre (1, 0) with speed 1.2.
struct Ellipse {
    static constexpr double mu = 1.001;
    double axis = 1.0 / (2.0 - 1.44 / mu);
    double eccentricity = 1.0 - 1.0 / axis;
    double frequency = std::sqrt(mu / axis) / axis;

    /// Kepler's equation E - e sin E = n t, solved by Newton's method.
    [[nodiscard]] Vec3 position(double time) const {
        const double anomaly = std::remainder(frequency * time, 2.0 * pi);
        double eccentric = anomaly;
        for (int i = 0; i < 50; ++i) {
            eccentric -=
                (eccentric - eccentricity * std::sin(eccentric) - anomaly) / (1.0 - eccentricity * std::cos(eccentric));
        }
        return {axis * (std::cos(eccentric) - eccentricity),
                axis * std::sqrt(1.0 - eccentricity * eccentricity) * std::sin(eccentric), 0.0};
    }

    [[nodiscard]] static State start() {
        State state = test::bodies_at({{1.0, 0.0, 0.0}}, {1.0});
        state.write_velocities().col(0) = Vec3(0.0, 1.2, 0.0);
        return state;
    }

    [[nodiscard]] static std::unique_ptr<ForceField> force() {
        return test::made_few_body_force("newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", mu}});
    }
};

/// Rearranges the bodies whenever it is asked, and then asks another force field.
class Shuffling : public ForceField {
  public:
    explicit Shuffling(std::unique_ptr<ForceField> inner) : inner_(std::move(inner)) {}

  private:
    Evaluation compute(State& state, Request request) override {
        state.reorder({2, 0, 1});
        return inner_->evaluate(state, request);
    }

    std::unique_ptr<ForceField> inner_;
};

/// Works until a body is beyond x = 1, then fails as it is told.
template <class Failure>
class Failing : public ForceField {
    Evaluation compute(State& state, Request) override {
        if (static_cast<const State&>(state).positions()(0, 0) > 1.0) {
            throw Failure("no force beyond 1");
        }
        state.write_forces().setZero();
        return {};
    }
};

/// No force until a body is beyond x = 1, then none that is a number.
class TurningNan : public ForceField {
    Evaluation compute(State& state, Request) override {
        const bool beyond = static_cast<const State&>(state).positions()(0, 0) > 1.0;
        state.write_forces().setConstant(beyond ? std::numeric_limits<double>::quiet_NaN() : 0.0);
        return {};
    }
};

/// No force until a body is beyond x = 1, then one that no step is short enough for; an error beyond x = 1.5.
class Rough : public ForceField {
  public:
    [[nodiscard]] bool has_thrown() const { return has_thrown_; }

  private:
    Evaluation compute(State& state, Request) override {
        const double x = static_cast<const State&>(state).positions()(0, 0);
        if (x > 1.5) {
            has_thrown_ = true;
            throw PhysicsError("no force beyond 1.5");
        }
        sign_ = -sign_;
        state.write_forces().setConstant(x > 1.0 ? 1e8 * sign_ : 0.0);
        return {};
    }

    double sign_ = 1.0;
    bool has_thrown_ = false;
};

/// A body that flies from the origin along x with speed 2.
State flying() {
    State state = test::bodies_at({{0.0, 0.0, 0.0}}, {1.0});
    state.write_velocities().col(0) = Vec3(2.0, 0.0, 0.0);
    return state;
}

}  // namespace

TEST_CASE("the reference solution of the Kepler problem is the ellipse, for 67 turns") {
    const Ellipse ellipse;
    CHECK(2.0 * pi / ellipse.frequency == Approx(14.928269695716399).epsilon(1e-14));
    const auto force = Ellipse::force();
    ReferenceTrajectory reference(Ellipse::start(), *force, tight);
    for (const double time : {0.5, 2.0 * pi / ellipse.frequency, 123.4, 1000.0}) {
        CAPTURE(time);
        const State& state = reference.advance_to(time);
        CHECK(state.time == time);
        CHECK((state.positions().col(0) - ellipse.position(time)).norm() < 1e-8);
    }
}

TEST_CASE("the error of the reference solution follows the tolerance") {
    const Ellipse ellipse;
    const auto force = Ellipse::force();
    double error = 1.0;
    Index steps = 0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
        CAPTURE(tolerance);
        ReferenceTrajectory reference(Ellipse::start(), *force, tolerance);
        const double now = (reference.advance_to(100.0).positions().col(0) - ellipse.position(100.0)).norm();
        CHECK(now < 0.1 * error);
        CHECK(reference.steps_taken() > steps);
        error = now;
        steps = reference.steps_taken();
    }
}

TEST_CASE("the reference solution of springs is the cosine, each mass at its own frequency, in three dimensions") {
    const auto force = test::made_few_body_force("harmonic", {{"stiffness", 2.0}});
    State start = test::bodies_at({{1.0, -2.0, 0.5}, {0.0, 3.0, 0.0}}, {0.5, 8.0});
    start.write_velocities().col(1) = Vec3(0.0, 0.0, 1.0);
    ReferenceTrajectory reference(start, *force, tight);
    const double time = 100.0;
    const State& state = reference.advance_to(time);
    CHECK((state.positions().col(0) - std::cos(2.0 * time) * Vec3(1.0, -2.0, 0.5)).norm() < 1e-10);
    CHECK((state.velocities().col(0) + 2.0 * std::sin(2.0 * time) * Vec3(1.0, -2.0, 0.5)).norm() < 1e-10);
    const Vec3 slow(0.0, 3.0 * std::cos(0.5 * time), 2.0 * std::sin(0.5 * time));
    CHECK((state.positions().col(1) - slow).norm() < 1e-10);
}

TEST_CASE("a pendulum that begins at 170 degrees is back after 4 K(sin 85 degrees)") {
    const double amplitude = 170.0 * pi / 180.0;
    const double period = 4.0 * gsl_sf_ellint_Kcomp(std::sin(0.5 * amplitude), GSL_PREC_DOUBLE);
    CHECK(period == Approx(15.326967999137).epsilon(1e-13));
    const auto force = test::made_few_body_force("pendulum", {{"gravity", 1.0}, {"length", 1.0}});
    const State start = test::bodies_at({{amplitude, 0.0, 0.0}}, {1.0});
    ReferenceTrajectory reference(start, *force, tight);
    CHECK(std::abs(reference.advance_to(0.25 * period).positions()(0, 0)) < 1e-10);
    CHECK(reference.advance_to(0.5 * period).positions()(0, 0) == Approx(-amplitude).epsilon(1e-10));
    CHECK(difference(reference.advance_to(period), start) < 1e-9);
    CHECK(difference(reference.advance_to(10.0 * period), start) < 1e-8);
}

TEST_CASE("three equal bodies on the figure eight are back after its period") {
    const State start = test::figure_eight();
    const auto force = unit_gravity();
    ReferenceTrajectory reference(start, *force, tight);
    CHECK(difference(reference.advance_to(test::figure_eight_period / 3.0), start) > 0.1);
    CHECK(difference(reference.advance_to(test::figure_eight_period), start) < 1e-7);
    CHECK(difference(reference.advance_to(0.0), start) < 1e-11);
}

TEST_CASE("the Pythagorean problem goes through its close encounters") {
    const State start = test::pythagorean();
    const auto force = unit_gravity();
    const Invariants before = invariants(start, *force);
    CHECK(before.energy == Approx(-12.816666666667).epsilon(1e-12));
    ReferenceTrajectory reference(start, *force, tight);

    // Expected: a Taylor series of order 32 in quadruple precision.
    CHECK(difference(reference.advance_to(10.0), {{0.7784804101, -2.0250924780, 1.1529857363},
                                                  {0.1413923003, 0.0972193841, -0.1626108875}}) < 1e-8);
    double closest = 1.0;
    for (int i = 0; i <= 100; ++i) {
        closest = std::min(closest, distance(reference.advance_to(15.825 + 1e-4 * i), 1, 2));
    }
    CHECK(closest < 0.006);
    CHECK(closest > 0.0);
    const State& late = reference.advance_to(30.0);
    CHECK(difference(late, {{0.8563404989, -0.8779838790, 0.1885828039},
                            {2.2870936637, -0.8659638277, -0.6794851360}}) < 1e-5);
    const Invariants after = invariants(late, *force);
    CHECK(after.energy == Approx(before.energy).epsilon(1e-7));
    CHECK(std::abs(after.angular_momentum) < 1e-9);
    CHECK(after.momentum.norm() < 1e-9);
}

TEST_CASE("the reference solution of the Pythagorean problem returns from its first encounters") {
    const State start = test::pythagorean();
    const auto force = unit_gravity();
    ReferenceTrajectory reference(start, *force, tight);
    CHECK(difference(reference.advance_to(5.0), start) > 1.0);
    CHECK(difference(reference.advance_to(0.0), start) < 1e-9);
}

TEST_CASE("a random three-body problem is followed as long as it can be predicted") {
    const State start = test::random_three_bodies();
    const auto force = unit_gravity();
    const Invariants before = invariants(start, *force);
    CHECK(before.energy == Approx(-0.277665711282).epsilon(1e-11));
    CHECK(before.angular_momentum == Approx(0.279319339529).epsilon(1e-11));
    CHECK((before.momentum - Vec3(0.341572065283, 0.770154526815, 0.0)).norm() < 1e-12);
    ReferenceTrajectory reference(start, *force, tight);
    // Expected: a Taylor series of order 32 in quadruple precision. The bodies meet closely again and again; each
    // meeting multiplies what doubles have rounded, so that nothing of the solution is left at t = 20.
    CHECK(difference(reference.advance_to(2.0),
                     {{0.9690385167, 1.4867646452, 1.1413649056}, {1.6506533393, 1.9597849188, 1.7045912573}}) < 1e-7);
    CHECK(difference(reference.advance_to(5.0),
                     {{2.0717495354, 1.7554457225, 1.4148203238}, {3.5189422543, 3.4791943859, 4.0837483877}}) < 3e-5);
    CHECK(difference(reference.advance_to(10.0),
                     {{3.5321566948, 3.3235137126, 2.2903489924}, {6.4118383826, 6.5331047101, 8.4513440561}}) < 2e-3);
}

TEST_CASE("a reference solution does not depend on where the bodies lie in memory") {
    const State start = test::random_three_bodies();
    const auto force = unit_gravity();
    Shuffling shuffling(unit_gravity());
    ReferenceTrajectory plain(start, *force, tight);
    ReferenceTrajectory shuffled(start, shuffling, tight);
    const State& expected = plain.advance_to(2.0);
    const State& found = shuffled.advance_to(2.0);
    for (Index i = 0; i < 3; ++i) {
        const Index id = found.ids()[static_cast<std::size_t>(i)];
        CHECK(found.positions().col(i) == expected.positions().col(id));
        CHECK(found.velocities().col(i) == expected.velocities().col(id));
    }
}

TEST_CASE("a reference solution begins at the time of its start, and asking for the present changes nothing") {
    State start = Ellipse::start();
    start.time = 7.0;
    const auto force = Ellipse::force();
    ReferenceTrajectory reference(start, *force, tight);
    CHECK(difference(reference.advance_to(7.0), start) == 0.0);
    CHECK(reference.steps_taken() == 0);
    CHECK((reference.advance_to(9.0).positions().col(0) - Ellipse().position(2.0)).norm() < 1e-12);
    const Index steps = reference.steps_taken();
    CHECK(steps > 0);
    CHECK((reference.advance_to(4.0).positions().col(0) - Ellipse().position(-3.0)).norm() < 1e-12);
    const Index more = reference.steps_taken();
    CHECK(more > steps);
    reference.advance_to(4.0 - 1e-6);
    CHECK(reference.steps_taken() == more + 1);
}

TEST_CASE("a solution over a span of time is the same at any time, to the last bit") {
    const auto force = unit_gravity();
    State start = test::figure_eight();
    ReferenceTrajectory early(start, *force, tight);
    start.time = 1e6 + 0.1;
    ReferenceTrajectory late(start, *force, tight);
    CHECK(difference(early.advance_by(0.7), late.advance_by(0.7)) == 0.0);
    CHECK(late.advance_by(0.0).time == 1e6 + 0.1 + 0.7);
    ReferenceTrajectory other(test::figure_eight(), *force, tight);
    CHECK(difference(other.advance_to(0.7), early.advance_by(0.0)) == 0.0);
    CHECK_THROWS_AS(other.advance_by(std::numeric_limits<double>::infinity()), ContractViolation);
}

TEST_CASE(
    "a solution is seen between its ends, in order, as exact as at its ends, and goes on as if nobody had looked") {
    const Ellipse ellipse;
    const auto force = Ellipse::force();
    ReferenceTrajectory watched(Ellipse::start(), *force, tight);
    ReferenceTrajectory alone(Ellipse::start(), *force, tight);
    double last = 0.0;
    Index seen = 0;
    const State& end = watched.advance_by(20.0, [&](const State& moment) {
        REQUIRE(moment.time > last);
        REQUIRE(moment.time < 20.0);
        last = moment.time;
        ++seen;
        REQUIRE((moment.positions().col(0) - ellipse.position(moment.time)).norm() < 1e-11);
    });
    CHECK(difference(end, alone.advance_by(20.0)) == 0.0);
    CHECK(watched.steps_taken() == alone.steps_taken());
    CHECK(seen > 6 * watched.steps_taken());
    CHECK(seen < 8 * watched.steps_taken());
}

TEST_CASE("two bodies that fall on each other end the reference solution when they meet") {
    const State start = test::bodies_at({{-0.5, 2.0, 0.0}, {0.5, 2.0, 0.0}}, {0.5, 0.5});
    const auto force = unit_gravity();
    ReferenceTrajectory reference(start, *force, tight);
    const double meeting = pi / std::sqrt(8.0);
    CHECK_THROWS_AS(reference.advance_to(2.0), PhysicsError);
    CHECK_THROWS_WITH(reference.advance_to(2.0), Catch::Contains("ends at time 1.1107") && Catch::Contains("before 2"));
    // It stands where it ended, and goes back from there.
    const State& back = reference.advance_to(0.5 * meeting);
    CHECK(back.time == 0.5 * meeting);
}

TEST_CASE("errors of a force field come through with their type, and the solution ends where they begin") {
    Failing<PhysicsError> physics;
    ReferenceTrajectory reference(flying(), physics, tight);
    CHECK_THROWS_AS(reference.advance_to(3.0), PhysicsError);
    CHECK_THROWS_WITH(reference.advance_to(3.0),
                      Catch::Matches("the solution ends at time 0[.](5|50000000.*|49999999.*), before 3: "
                                     "no force beyond 1"));
    CHECK(reference.advance_to(0.25).positions()(0, 0) == Approx(0.5).epsilon(1e-13));

    Failing<ContractViolation> contract;
    ReferenceTrajectory other(flying(), contract, tight);
    CHECK_THROWS_AS(other.advance_to(3.0), ContractViolation);

    TurningNan nan;
    ReferenceTrajectory third(flying(), nan, tight);
    CHECK_THROWS_WITH(third.advance_to(3.0), Catch::Contains("body 1") && Catch::Contains("not finite"));
}

TEST_CASE("an error met in a step that was too long is forgotten when shorter ones go around it") {
    Rough rough;
    ReferenceTrajectory reference(flying(), rough, tight);
    CHECK_THROWS_WITH(reference.advance_to(3.0), Catch::Contains("the tolerance asks for more than doubles hold"));
    CHECK(rough.has_thrown());
}

TEST_CASE("a reference solution refuses boxes, empty states, and tolerances and times that are none") {
    const auto force = unit_gravity();
    CHECK_THROWS_AS(ReferenceTrajectory(State(2, Box(Vec3::Constant(5.0))), *force, tight), ContractViolation);
    CHECK_THROWS_AS(ReferenceTrajectory(State(0), *force, tight), ContractViolation);
    for (const double tolerance : {0.0, -1e-9, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_THROWS_AS(ReferenceTrajectory(test::figure_eight(), *force, tolerance), ContractViolation);
    }
    ReferenceTrajectory reference(test::figure_eight(), *force, tight);
    CHECK_THROWS_AS(reference.advance_to(std::numeric_limits<double>::infinity()), ContractViolation);
}
