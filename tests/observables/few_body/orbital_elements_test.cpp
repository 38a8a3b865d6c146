#include "observables/few_body/orbital_elements.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "observables/kepler.hpp"

using namespace ljmd;

namespace {
constexpr double tight = 1e-14;
}

TEST_CASE("An ellipse that starts at its pericentre has the elements worked out by hand") {
    const OrbitalElements orbit = orbital_elements({1.0, 0.0, 0.0}, {0.0, 1.2, 0.0}, 1.001);
    CHECK(orbit.specific_energy == Approx(-0.281).epsilon(tight));
    CHECK(orbit.angular_momentum == Vec3(0.0, 0.0, 1.2));
    CHECK(orbit.semi_major_axis == Approx(1.7811387900355875).epsilon(tight));
    CHECK(orbit.eccentricity == Approx(0.4385614385614386).epsilon(tight));
    CHECK(orbit.period == Approx(14.928269695716399).epsilon(tight));
    CHECK(orbit.pericentre == Approx(1.0).epsilon(tight));
    CHECK(orbit.apocentre == Approx(2.562277580071175).epsilon(tight));
    CHECK(orbit.angular_momentum.norm() / orbit.apocentre == Approx(0.4683333333333333).epsilon(tight));
    CHECK(orbit.argument_of_pericentre == Approx(0.0).margin(tight));
}

TEST_CASE("The elements are the same all along an orbit, in any plane and direction") {
    const kepler::Ellipse ellipse = kepler::sample_ellipse();
    const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    for (const double t : {0.3, 4.0, 7.5, 11.0}) {
        CAPTURE(t);
        const kepler::Point point = ellipse.at(t);
        const OrbitalElements orbit = orbital_elements(tilt * point.r, tilt * point.v, ellipse.mu);
        CHECK(orbit.semi_major_axis == Approx(ellipse.a).epsilon(tight));
        CHECK(orbit.eccentricity == Approx(ellipse.e).epsilon(tight));
        CHECK(orbit.period == Approx(ellipse.period()).epsilon(tight));
        CHECK((orbit.angular_momentum - tilt * Vec3(0.0, 0.0, 1.2)).norm() < tight);
        const Vec3 towards = tilt * Vec3::UnitX();
        CHECK(orbit.argument_of_pericentre == Approx(std::atan2(towards.y(), towards.x())).margin(tight));
    }
}

TEST_CASE("The argument of pericentre is its direction in the plane, whichever way the body goes") {
    for (const double angle : {-2.5, -0.4, 1.0, 3.0}) {
        for (const double sense : {1.0, -1.0}) {
            CAPTURE(angle, sense);
            const kepler::Point point = kepler::sample_ellipse().at(2.0);
            const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
            const Vec3 mirror(1.0, sense, 1.0);
            const OrbitalElements orbit =
                orbital_elements(turn * mirror.cwiseProduct(point.r), turn * mirror.cwiseProduct(point.v), 1.001);
            CHECK(orbit.argument_of_pericentre == Approx(angle).epsilon(1e-13));
            CHECK(orbit.angular_momentum.z() == Approx(sense * 1.2).epsilon(tight));
        }
    }
}

TEST_CASE("A hyperbola and a parabola have a pericentre, no period and no apocentre") {
    const double infinity = std::numeric_limits<double>::infinity();
    const OrbitalElements hyperbola = orbital_elements({0.0, 2.0, 0.0}, {-1.5, 0.0, 0.0}, 1.0);
    CHECK(hyperbola.specific_energy == Approx(0.625).epsilon(tight));
    CHECK(hyperbola.semi_major_axis == Approx(-0.8).epsilon(tight));
    CHECK(hyperbola.eccentricity == Approx(3.5).epsilon(tight));
    CHECK(hyperbola.pericentre == Approx(2.0).epsilon(tight));
    CHECK(hyperbola.period == infinity);
    CHECK(hyperbola.apocentre == infinity);
    CHECK(hyperbola.argument_of_pericentre == Approx(0.5 * std::numbers::pi).epsilon(tight));

    const OrbitalElements parabola = orbital_elements({2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1.0);
    CHECK(parabola.specific_energy == 0.0);
    CHECK(parabola.semi_major_axis == infinity);
    CHECK(parabola.eccentricity == 1.0);
    CHECK(parabola.pericentre == 2.0);
    CHECK(parabola.period == infinity);
    CHECK(parabola.apocentre == infinity);
}

TEST_CASE("A circle has eccentricity 0, a fall along a line eccentricity 1") {
    const OrbitalElements circle = orbital_elements({0.0, 0.0, 4.0}, {0.0, 0.5, 0.0}, 1.0);
    CHECK(circle.eccentricity == 0.0);
    CHECK(circle.pericentre == 4.0);
    CHECK(circle.apocentre == 4.0);
    CHECK(circle.period == Approx(16.0 * std::numbers::pi).epsilon(tight));

    const OrbitalElements line = orbital_elements({1.0, 1.0, 0.0}, {0.25, 0.25, 0.0}, 1.0);
    CHECK(line.eccentricity == Approx(1.0).epsilon(tight));
    CHECK(line.pericentre == 0.0);
    CHECK(line.apocentre == Approx(2.0 * line.semi_major_axis).epsilon(tight));
}

TEST_CASE("Elements without attraction or without distance are refused") {
    CHECK_THROWS_AS(orbital_elements(Vec3::UnitX(), Vec3::UnitY(), 0.0), ContractViolation);
    CHECK_THROWS_AS(orbital_elements(Vec3::UnitX(), Vec3::UnitY(), -1.0), ContractViolation);
    CHECK_THROWS_AS(orbital_elements(Vec3::Zero(), Vec3::UnitY(), 1.0), ContractViolation);
}
