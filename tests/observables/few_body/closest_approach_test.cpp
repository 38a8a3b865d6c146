#include "observables/few_body/closest_approach.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "observables/kepler.hpp"

using namespace ljmd;

namespace {

State bodies(double time, const Eigen::Matrix3Xd& r, const Eigen::Matrix3Xd& v) {
    State state(r.cols());
    state.time = time;
    state.write_positions() = r;
    state.write_velocities() = v;
    return state;
}

/// The first body at rest far away, the third on an ellipse about the second, over two periods.
Approach closest_on_ellipse(double dt, double begin) {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    ClosestApproach approach;
    for (Index i = 0; static_cast<double>(i) * dt < 2.0 * ellipse.period(); ++i) {
        const double t = begin + static_cast<double>(i) * dt;
        const kepler::Point point = ellipse.at(t);
        Eigen::Matrix3Xd r = Eigen::Matrix3Xd::Zero(3, 3);
        Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Zero(3, 3);
        r.col(0) = Vec3(0.0, 0.0, 10.0);
        r.col(2) = point.r;
        v.col(2) = point.v;
        approach.add(bodies(t, r, v));
    }
    return approach.closest().value();
}

}  // namespace

TEST_CASE("Bodies on straight lines are nearest between the samples") {
    Eigen::Matrix3Xd r(3, 3);
    Eigen::Matrix3Xd v(3, 3);
    // Bodies 1 and 3 pass each other at 0.25 when t = 0.4; body 2 stays 2 away.
    r << -0.4, 0.0, 0.4, 0.0, 2.25, 0.25, 0.0, 0.0, 0.0;
    v << 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0;
    ClosestApproach approach;
    approach.add(bodies(0.0, r, v));
    approach.add(bodies(1.0, r + v, v));
    REQUIRE(approach.closest());
    CHECK(approach.closest()->distance == Approx(0.25).epsilon(1e-14));
    CHECK(approach.closest()->time == Approx(0.4).epsilon(1e-14));
    CHECK(approach.closest()->first == 1);
    CHECK(approach.closest()->second == 3);
}

TEST_CASE("The order in memory changes neither the bodies' names nor the approach") {
    Eigen::Matrix3Xd r(3, 3);
    Eigen::Matrix3Xd v(3, 3);
    r << -0.4, 0.0, 0.4, 0.0, 2.25, 0.25, 0.0, 0.0, 0.0;
    v << 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0;
    ClosestApproach approach;
    approach.add(bodies(0.0, r, v));
    State later = bodies(1.0, r + v, v);
    later.reorder({2, 0, 1});
    approach.add(later);
    CHECK(approach.closest()->distance == Approx(0.25).epsilon(1e-14));
    CHECK(approach.closest()->first == 1);
    CHECK(approach.closest()->second == 3);
}

TEST_CASE("The pericentre of an ellipse is found, with an error of fourth order in the step") {
    const Approach found = closest_on_ellipse(0.01, 2.0);
    CHECK(found.first == 2);
    CHECK(found.second == 3);
    CHECK(found.distance == Approx(1.0).margin(1e-10));
    const double periods = found.time / kepler::sample_ellipse().period();
    CHECK(periods == Approx(std::round(periods)).margin(1e-8));

    // Steps that have the first pericentre in the middle of one.
    const auto error = [](double dt) {
        return std::abs(closest_on_ellipse(dt, kepler::sample_ellipse().period() - 10.5 * dt).distance - 1.0);
    };
    CHECK(std::log2(error(0.2) / error(0.1)) == Approx(4.0).margin(0.2));
}

TEST_CASE("An encounter is resolved when bodies move by less than half of their distance in a step") {
    // Body 2 passes body 1 at (0, 1), with speed v: the step is as long as its path.
    const auto passing = [](double path) {
        Eigen::Matrix3Xd r = Eigen::Matrix3Xd::Zero(3, 2);
        Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Zero(3, 2);
        r.col(1) = Vec3(-0.4 * path, 1.0, 0.0);
        v(0, 1) = 2.0 * path;
        ClosestApproach approach;
        approach.add(bodies(3.0, r, v));
        approach.add(bodies(3.5, r + 0.5 * v, v));
        // A nearer one, that is over within a thousandth of its distance, comes later: the motion is wrong before.
        r.col(1) = Vec3(-1e-4, 0.5, 0.0);
        v(0, 1) = 0.2;
        approach.add(bodies(4.0, r, v));
        approach.add(bodies(4.001, r + 0.001 * v, v));
        CHECK(approach.closest().value().resolved());
        CHECK(approach.closest().value().distance == Approx(0.5));
        return approach.first_unresolved();
    };
    CHECK_FALSE(passing(0.499));
    const auto unresolved = passing(0.501);
    REQUIRE(unresolved);
    CHECK(unresolved->distance == Approx(1.0).epsilon(1e-14));
    CHECK(unresolved->time == Approx(3.2).epsilon(1e-14));
    CHECK(unresolved->path_in_step == Approx(0.501).epsilon(1e-14));
}

TEST_CASE("An encounter that a motion begins with must be resolved, too") {
    const auto beginning = [](double step) {
        Eigen::Matrix3Xd r = Eigen::Matrix3Xd::Zero(3, 2);
        Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Zero(3, 2);
        r.col(1) = Vec3(0.6, 0.8, 0.0);
        v.col(1) = Vec3(-0.8, 0.6, 0.0);
        ClosestApproach approach;
        approach.add(bodies(1.0, r, v));
        approach.add(bodies(1.0 + step, r + step * v, v));
        return approach.first_unresolved();
    };
    CHECK_FALSE(beginning(0.499));
    REQUIRE(beginning(0.501));
    CHECK(beginning(0.501)->time == 1.0);
    CHECK(beginning(0.501)->path_in_step == Approx(0.501));
}

TEST_CASE("A sample that is nearer than any minimum counts") {
    Eigen::Matrix3Xd r(3, 2);
    Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Zero(3, 2);
    r << 0.0, 3.0, 0.0, 4.0, 0.0, 0.0;
    v.col(1) = Vec3(3.0, 4.0, 0.0);
    ClosestApproach approach;
    CHECK_FALSE(approach.closest());
    approach.add(bodies(2.0, r, v));
    approach.add(bodies(3.0, r + v, v));
    CHECK(approach.closest()->distance == 5.0);
    CHECK(approach.closest()->time == 2.0);
}

TEST_CASE("A single body approaches nobody, and samples that do not follow are refused") {
    ClosestApproach single;
    single.add(State(1));
    CHECK_FALSE(single.closest());
    CHECK_THROWS_AS(single.add(State(1)), ContractViolation);
    State two(2);
    two.time = 1.0;
    CHECK_THROWS_AS(single.add(two), ContractViolation);
}

TEST_CASE("approaches are continued from their last sample or later, and with as many bodies") {
    State two(2);
    two.time = 1.0;
    ClosestApproach approach;
    approach.add(two);
    Archive a;
    approach.archive(a, two);
    ClosestApproach other;
    Archive same(a.bytes());
    CHECK_NOTHROW(other.archive(same, two));
    two.time = 0.5;
    Archive earlier(a.bytes());
    CHECK_THROWS_AS(other.archive(earlier, two), CheckpointError);
    State three(3);
    three.time = 1.0;
    Archive more(a.bytes());
    CHECK_THROWS_AS(other.archive(more, three), CheckpointError);
}
