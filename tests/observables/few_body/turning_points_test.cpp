#include "observables/few_body/turning_points.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "observables/kepler.hpp"

using namespace ljmd;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Apsides of an orbit, Point orbit(t), sampled from `begin` to `end`.
template <class Orbit>
TurningPoints apsides(const Orbit& orbit, double begin, double end, double dt) {
    TurningPoints points;
    const auto steps = static_cast<Index>(std::floor((end - begin) / dt));
    for (Index i = 0; i <= steps; ++i) {
        const double t = begin + static_cast<double>(i) * dt;
        const kepler::Point point = orbit(t);
        points.add(t, point.r, point.v);
    }
    return points;
}

TurningPoints apsides_of_leapfrog(double mu, double speed, double dt, double end) {
    kepler::Leapfrog body({Vec3(1.0, 0.0, 0.0), Vec3(0.0, speed, 0.0)}, mu, dt);
    TurningPoints points;
    for (Index i = 0; static_cast<double>(i) * dt < end; ++i) {
        points.add(static_cast<double>(i) * dt, body.now().r, body.now().v);
        body.step();
    }
    return points;
}

/// Largest errors over the passages of the ellipse, that began at its pericentre at time 0.
struct Errors {
    double time = 0.0;
    double distance = 0.0;
    double angle = 0.0;
};

Errors errors_of(const TurningPoints& points, const kepler::Ellipse& ellipse, Apsis kind) {
    Errors errors;
    for (std::size_t k = 0; k < points.passages().size(); ++k) {
        const Passage& passage = points.passages()[k];
        const bool near = k % 2 == 0;
        REQUIRE(passage.kind == (near ? Apsis::pericentre : Apsis::apocentre));
        if (passage.kind == kind) {
            const double halves = 0.5 * static_cast<double>(k);
            const double exact = ellipse.a * (near ? 1.0 - ellipse.e : 1.0 + ellipse.e);
            errors.time = std::max(errors.time, std::abs(passage.time - halves * ellipse.period()));
            errors.distance = std::max(errors.distance, std::abs(passage.distance - exact));
            errors.angle = std::max(errors.angle, std::abs(passage.angle - halves * turn));
        }
    }
    return errors;
}

}  // namespace

TEST_CASE("Apsides of an exact ellipse lie where Kepler puts them") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    const TurningPoints points = apsides([&](double t) { return ellipse.at(t); }, 0.0, 10.2 * ellipse.period(), 0.01);
    REQUIRE(points.passages().size() == 21);

    const Passage& first = points.passages().front();
    CHECK(first.kind == Apsis::pericentre);
    CHECK(first.time == 0.0);
    CHECK(first.distance == Approx(1.0).epsilon(1e-15));
    CHECK(first.angle == 0.0);
    CHECK(first.path_in_step == Approx(0.012).epsilon(1e-14));  // speed 1.2

    const Errors near = errors_of(points, ellipse, Apsis::pericentre);
    const Errors far = errors_of(points, ellipse, Apsis::apocentre);
    CHECK(near.time < 6e-8);
    CHECK(near.distance < 1e-10);
    CHECK(near.angle < 6e-8);
    CHECK(far.time < 1e-9);
    CHECK(far.distance < 1e-12);
    CHECK(far.angle < 1e-9);

    REQUIRE(points.period());
    CHECK(points.period()->mean == Approx(14.928269695716399).margin(1e-9));
    CHECK(points.period()->intervals == 9);
    CHECK(points.period()->standard_error < 1e-9);
    REQUIRE(points.precession());
    CHECK(std::abs(points.precession()->mean) < 1e-10);
    CHECK(points.precession()->standard_error < 1e-9);
}

TEST_CASE("The error of an apsis falls with the fourth power of the step in distance, the third in time and angle") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    // Over many passages every place of an apsis within its step comes up, the worst included.
    const auto errors = [&](double dt) {
        const auto points = apsides([&](double t) { return ellipse.at(t); }, 0.0, 60.2 * ellipse.period(), dt);
        return errors_of(points, ellipse, Apsis::pericentre);
    };
    const Errors coarse = errors(0.1);
    const Errors fine = errors(0.025);
    CHECK(std::log2(coarse.distance / fine.distance) / 2.0 == Approx(4.0).margin(0.2));
    CHECK(std::log2(coarse.time / fine.time) / 2.0 == Approx(3.0).margin(0.2));
    CHECK(std::log2(coarse.angle / fine.angle) / 2.0 == Approx(3.0).margin(0.2));
}

TEST_CASE(
    "A turning ellipse precesses by what it turns in a period, forwards and backwards, for both senses of motion") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    for (const double precession : {0.3, 1e-4, -1e-4, -0.3}) {
        for (const double sense : {1.0, -1.0}) {
            CAPTURE(precession, sense);
            const double rate = precession / ellipse.period();
            const auto orbit = [&](double t) {
                kepler::Point point = kepler::turned(ellipse.at(t), rate * t, rate);
                point.r.y() *= sense;
                point.v.y() *= sense;
                return point;
            };
            const TurningPoints points = apsides(orbit, 1.0, 12.0 * ellipse.period(), 0.01);
            REQUIRE(points.precession());
            CHECK(points.precession()->mean == Approx(precession).margin(1e-9));
            CHECK(points.period()->mean == Approx(ellipse.period()).margin(1e-9));
        }
    }
}

TEST_CASE("Apsides do not depend on the plane of the orbit") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    const Eigen::AngleAxisd tilt(1.1, Vec3(0.6, -0.3, 1.0).normalized());
    const double rate = 0.02 / ellipse.period();
    const auto flat = [&](double t) { return kepler::turned(ellipse.at(t), rate * t, rate); };
    const auto tilted = [&](double t) {
        const kepler::Point point = flat(t);
        return kepler::Point{tilt * point.r, tilt * point.v};
    };
    const TurningPoints expected = apsides(flat, 2.0, 80.0, 0.01);
    const TurningPoints points = apsides(tilted, 2.0, 80.0, 0.01);
    REQUIRE(points.passages().size() == expected.passages().size());
    REQUIRE(points.passages().size() == 10);
    for (std::size_t i = 0; i < points.passages().size(); ++i) {
        CHECK(points.passages()[i].kind == expected.passages()[i].kind);
        CHECK(points.passages()[i].time == Approx(expected.passages()[i].time).margin(1e-11));
        CHECK(points.passages()[i].distance == Approx(expected.passages()[i].distance).margin(1e-13));
        CHECK(points.passages()[i].angle == Approx(expected.passages()[i].angle).margin(1e-11));
    }
    CHECK(points.precession()->mean == Approx(0.02).margin(1e-9));
}

TEST_CASE("Angles are counted from the first sample") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    const TurningPoints points = apsides([&](double t) { return ellipse.at(t); }, 3.0, 20.0, 0.01);
    const Vec3 first = ellipse.at(3.0).r;
    REQUIRE(points.passages().size() == 2);
    CHECK(points.passages()[0].kind == Apsis::apocentre);
    CHECK(points.passages()[0].angle == Approx(0.5 * turn - std::atan2(first.y(), first.x())).margin(1e-8));
    CHECK(points.passages()[1].angle == Approx(turn - std::atan2(first.y(), first.x())).margin(1e-8));
}

TEST_CASE("Leapfrog turns the apsides of an ellipse backwards, by a second order of the step") {
    const TurningPoints points = apsides_of_leapfrog(1.001, 1.2, 0.01, 160.0);
    REQUIRE(points.precession());
    CHECK(points.precession()->mean == Approx(-5.535e-5).margin(1e-8));
    CHECK(points.period()->mean == Approx(14.92888).margin(1e-5));  // longer than Kepler's by 6.1e-4

    const double halved = apsides_of_leapfrog(1.001, 1.2, 0.005, 160.0).precession()->mean;
    CHECK(points.precession()->mean / halved == Approx(4.0).margin(0.01));
}

TEST_CASE("Leapfrog turns the apsides of a narrow ellipse by much more") {
    // The coarse step is a third of the pericentre's passage: apocentres alone tell the precession, pericentres
    // scatter.
    CHECK(apsides_of_leapfrog(1.0, 0.3, 0.005, 40.0).precession()->mean == Approx(-6.17e-2).margin(1e-4));
    const TurningPoints fine = apsides_of_leapfrog(1.0, 0.3, 0.001, 40.0);
    CHECK(fine.precession()->mean == Approx(-2.595e-3).margin(1e-6));
    CHECK(fine.precession()->standard_error < 1e-6);
}

TEST_CASE("A hyperbola has one apsis and no period, a circle no apsis") {
    kepler::Leapfrog flyby({Vec3(4.0, 1.0, 0.0), Vec3(-2.0, 0.0, 0.0)}, 1.0, 0.001);
    TurningPoints points;
    for (Index i = 0; i < 5000; ++i) {
        points.add(static_cast<double>(i), flyby.now().r, flyby.now().v);
        flyby.step();
    }
    REQUIRE(points.passages().size() == 1);
    CHECK(points.passages()[0].kind == Apsis::pericentre);
    CHECK_FALSE(points.period());
    CHECK_FALSE(points.precession());

    const Eigen::AngleAxisd tilt(0.4, Vec3(0.6, -0.3, 1.0).normalized());  // so that r . v is rounding, not zero
    const auto circle = [&](double t) {
        return kepler::Point{tilt * Vec3(std::cos(t), std::sin(t), 0.0), tilt * Vec3(-std::sin(t), std::cos(t), 0.0)};
    };
    CHECK(apsides(circle, 0.0, 30.0, 0.01).passages().empty());
}

TEST_CASE("A start at an apsis is a passage whatever the rounding of r times v") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    for (int k = 0; k < 20; ++k) {
        CAPTURE(k);
        const Eigen::AngleAxisd tilt(0.3 * k, Vec3(0.6, -0.3, 1.0).normalized());
        const auto orbit = [&](double t) {
            const kepler::Point point = ellipse.at(t);
            return kepler::Point{tilt * point.r, tilt * point.v};
        };
        const TurningPoints points = apsides(orbit, 0.0, 10.0, 0.1);
        REQUIRE(points.passages().size() == 2);
        CHECK(points.passages()[0].kind == Apsis::pericentre);
        CHECK(points.passages()[0].time == 0.0);
    }
}

TEST_CASE("A radial motion has its turning points, with the angle that the caller gives") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    const double h = 1.2;
    for (const double sense : {1.0, -1.0}) {
        TurningPoints points;
        double turned = 0.0;
        double last = 0.0;
        for (Index i = 0; i < 8000; ++i) {
            const double t = 0.01 * static_cast<double>(i);
            const kepler::Point point = ellipse.at(t);
            const double rho = point.r.norm();
            const double polar = std::atan2(point.r.y(), point.r.x());
            turned += polar < last - 1.0 ? turn : 0.0;
            last = polar;
            points.add_radial(t, rho, point.r.dot(point.v) / rho, sense * 1.001 * (polar + turned),
                              sense * 1.001 * h / (rho * rho));
        }
        REQUIRE(points.passages().size() == 11);
        CHECK(points.passages()[0].kind == Apsis::pericentre);
        CHECK(points.passages()[0].time == 0.0);
        CHECK(points.passages()[0].path_in_step == Approx(1.001 * 0.012).epsilon(1e-12));
        CHECK(points.passages()[2].path_in_step == Approx(1.001 * 0.012).epsilon(1e-6));
        CHECK(points.passages()[1].distance == Approx(2.562277580071175).margin(1e-10));
        CHECK(points.passages()[1].angle == Approx(sense * 1.001 * 0.5 * turn).margin(1e-8));
        CHECK(points.period()->mean == Approx(ellipse.period()).margin(1e-9));
        CHECK(points.precession()->mean == Approx(0.001 * turn).margin(1e-9));
    }
}

TEST_CASE("A vibration along a line that begins at rest has a period and no precession") {
    const auto vibration = [](double t) {
        return kepler::Point{(2.0 + 0.1 * std::cos(3.0 * t)) * Vec3(0.0, 0.6, 0.8),
                             -0.3 * std::sin(3.0 * t) * Vec3(0.0, 0.6, 0.8)};
    };
    const TurningPoints points = apsides(vibration, 0.0, 20.0, 0.01);
    REQUIRE(points.passages().size() > 2);
    CHECK(points.passages()[0].kind == Apsis::apocentre);
    CHECK(points.passages()[0].time == 0.0);
    CHECK(points.passages()[1].distance == Approx(1.9).margin(1e-8));
    CHECK(std::isnan(points.passages()[1].angle));
    CHECK(points.period()->mean == Approx(turn / 3.0).margin(1e-6));
    CHECK_FALSE(points.precession());
}

TEST_CASE("Samples of an orbit that do not follow in time are refused") {
    TurningPoints points;
    points.add(1.0, Vec3::UnitX(), Vec3::UnitY());
    CHECK_THROWS_AS(points.add(1.0, Vec3::UnitX(), Vec3::UnitY()), ContractViolation);
    CHECK_THROWS_AS(points.add_radial(0.5, 1.0, 0.0, 0.0, 0.0), ContractViolation);
}

TEST_CASE("an orbit is continued from its last sample or later") {
    TurningPoints points;
    points.add(1.0, Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0));
    Archive a;
    points.archive(a, 1.0);
    TurningPoints other;
    Archive same(a.bytes());
    CHECK_NOTHROW(other.archive(same, 1.0));
    Archive earlier(a.bytes());
    CHECK_THROWS_AS(other.archive(earlier, 0.5), CheckpointError);
}
