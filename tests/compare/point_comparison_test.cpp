#include "compare/point_comparison.hpp"

#include <limits>
#include "catch.hpp"

#include "compare/small_fluid.hpp"
#include "forces/pair_force_field.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

PeerPoint small_point(const Fluid& fluid) {
    PairForceField force_field(fluid.potential, make_pair_search("all-pairs", 0.3));
    return point_of(fluid, force_field);
}

Check find(const std::vector<Check>& checks, const std::string& name) {
    for (const Check& check : checks) {
        if (check.name == name) {
            return check;
        }
    }
    FAIL("no check is called " << name);
    return {};
}

}  // namespace

TEST_CASE("a point holds energy, virial, forces by id and tails of a fluid") {
    const Fluid fluid = small_fluid("lennard-jones", "cut", true);
    const PeerPoint point = small_point(fluid);
    // By hand: three pairs, one of them through the wall at z = 8.
    double u = 0.0;
    double w = 0.0;
    std::vector<Vec3> forces(3, Vec3::Zero());
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
            Vec3 d = fluid.positions[i] - fluid.positions[j];
            d -= (d.array() / fluid.edges.array()).round().matrix().cwiseProduct(fluid.edges);
            const double r = d.norm();
            if (r < 2.5) {
                const double s6 = std::pow(r, -6);
                u += 4.0 * (s6 * s6 - s6);
                w += 24.0 * (2.0 * s6 * s6 - s6);
                forces[i] += 24.0 * (2.0 * s6 * s6 - s6) / (r * r) * d;
                forces[j] -= 24.0 * (2.0 * s6 * s6 - s6) / (r * r) * d;
            }
        }
    }
    CHECK(point.totals.potential_energy == Approx(u).epsilon(1e-13));
    CHECK(point.totals.virial == Approx(w).epsilon(1e-13));
    CHECK(point.totals.kinetic_energy == kinetic_energy(fluid));
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK((point.forces[i] - forces[i]).norm() < 1e-12 * forces[i].norm());
    }
    const TailCorrection tail(fluid.potential);
    CHECK(point.tail_energy == tail.energy(3.0 / 336.0));
    CHECK(point.tail_pressure == tail.pressure(3.0 / 336.0));
    CHECK(pressure(point.totals, fluid) == Approx((2.0 * kinetic_energy(fluid) + w) / (3.0 * 336.0)));
    CHECK_FALSE(small_point(small_fluid()).tail_energy);
}

TEST_CASE("equal points are apart by nothing") {
    const Fluid fluid = small_fluid("lennard-jones", "cut", true);
    const PeerPoint point = small_point(fluid);
    const std::vector<Check> checks = compare_points(point, point, fluid, double_agreement({}));
    REQUIRE(checks.size() == 6);
    for (const Check& check : checks) {
        INFO(check.name);
        CHECK(check.value == 0.0);
        CHECK(check.passed());
    }
}

TEST_CASE("each number of a point is held against its own tolerance") {
    const Fluid fluid = small_fluid("lennard-jones", "cut", true);
    const PeerPoint theirs = small_point(fluid);
    const Agreement agreement = double_agreement({});
    const auto value = [&](const PeerPoint& ours, const std::string& name) {
        return find(compare_points(ours, theirs, fluid, agreement), name).value;
    };

    PeerPoint ours = theirs;
    ours.totals.potential_energy *= 1.0 + 1e-9;
    CHECK(value(ours, "potential energy") == Approx(1e-9).epsilon(1e-5));

    ours = theirs;
    const double rms = std::sqrt(
        (theirs.forces[0].squaredNorm() + theirs.forces[1].squaredNorm() + theirs.forces[2].squaredNorm()) / 3.0);
    ours.forces[2][1] += 1e-6 * rms;
    CHECK(value(ours, "largest force difference") == Approx(1e-6).epsilon(1e-5));
    CHECK(value(ours, "rms force difference") == Approx(1e-6 / std::sqrt(3.0)).epsilon(1e-5));

    ours = theirs;
    ours.totals.virial += 1e-8 * (2.0 * theirs.totals.kinetic_energy + std::abs(theirs.totals.virial));
    CHECK(value(ours, "pressure") == Approx(1e-8).epsilon(1e-5));

    ours = theirs;
    *ours.tail_energy *= 1.0 + 1e-7;
    *ours.tail_pressure *= 1.0 - 1e-7;
    CHECK(value(ours, "tail correction of the energy") == Approx(1e-7).epsilon(1e-5));
    CHECK(value(ours, "tail correction of the pressure") == Approx(1e-7).epsilon(1e-5));
    for (const Check& check : compare_points(ours, theirs, fluid, agreement)) {
        CHECK(check.passed() == (check.value == 0.0));
    }
}

TEST_CASE("a force that is not a number fails") {
    const Fluid fluid = small_fluid();
    const PeerPoint theirs = small_point(fluid);
    PeerPoint ours = theirs;
    ours.forces[0][2] = std::numeric_limits<double>::quiet_NaN();
    const auto checks = compare_points(ours, theirs, fluid, double_agreement({}));
    CHECK_FALSE(find(checks, "largest force difference").passed());
    CHECK_FALSE(find(checks, "rms force difference").passed());
}

TEST_CASE("where forces vanish, differences of forces are absolute") {
    const Fluid fluid = small_fluid();
    PeerPoint theirs = small_point(fluid);
    theirs.forces = {Vec3::Zero(), Vec3(1e-15, 0.0, 0.0), Vec3::Zero()};
    PeerPoint ours = theirs;
    ours.forces[0] = Vec3(0.0, 3e-15, 0.0);
    CHECK(find(compare_points(ours, theirs, fluid, double_agreement({})), "largest force difference").value ==
          Approx(3e-15));
}
