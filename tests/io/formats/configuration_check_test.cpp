#include "io/formats/configuration_check.hpp"

#include <limits>
#include "catch.hpp"

#include "io/two_atoms.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using ljmd::test::two_atoms;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("nothing is wrong with a good configuration") {
    CHECK_FALSE(find_fault(two_atoms()).has_value());
    Configuration bare = two_atoms();
    bare.velocities.clear();
    bare.masses.clear();
    CHECK_FALSE(find_fault(bare).has_value());
}

TEST_CASE("atoms at the same place modulo the box are found, and none that are apart") {
    CHECK_FALSE(find_coincident_atoms(two_atoms()).has_value());
    Configuration same = two_atoms();
    same.positions[1] = same.positions[0] + Vec3(same.edges[0], 0.0, -2.0 * same.edges[2]);
    CHECK(find_coincident_atoms(same) == std::pair<Index, Index>(0, 1));
}

TEST_CASE("tilts of zero, or of rounding, are an orthogonal box, and no others are") {
    Mat3 vectors = Mat3(Vec3(34.0, 5.0, 60.0).asDiagonal());
    CHECK(is_orthogonal(vectors));
    vectors(1, 0) = -0.0;
    vectors(2, 1) = 60.0 * 6.1e-17;  // 60 cos(90 degrees)
    vectors(2, 0) = 4e-16 * 34.0;
    CHECK(is_orthogonal(vectors));
    vectors(2, 0) = 1e-9;
    CHECK_FALSE(is_orthogonal(vectors));
    CHECK_FALSE(is_orthogonal(vectors.transpose()));
}

TEST_CASE("what cannot be computed with is found, and in which atom") {
    const auto fault = [](auto change) {
        Configuration configuration = two_atoms();
        change(configuration);
        return find_fault(configuration).value();
    };
    CHECK_THAT(fault([](Configuration& c) { c.edges[1] = 0.0; }).message, Contains("must be positive"));
    CHECK_THAT(fault([](Configuration& c) { c.edges[1] = nothing; }).message, Contains("must be positive"));
    CHECK_THAT(fault([](Configuration& c) { c.edges[1] = 1e8; }).message, Contains("differ by more than"));
    CHECK_THAT(fault([](Configuration& c) { c.edges *= 1e-150; }).message, Contains("the volume"));
    CHECK_THAT(fault([](Configuration& c) { c.time = nothing; }).message, Contains("the time is not finite"));
    const auto of_second = [&](auto change) {
        const ConfigurationFault found = fault(change);
        CHECK(found.atom == Index{1});
        return found.message;
    };
    CHECK_THAT(of_second([](Configuration& c) { c.positions[1][2] = nothing; }), Contains("position that is not"));
    CHECK_THAT(of_second([](Configuration& c) { c.positions[1][2] = -1e7; }), Contains("edges away"));
    CHECK_THAT(of_second([](Configuration& c) { c.velocities[1][0] = nothing; }), Contains("velocity that is not"));
    CHECK_THAT(of_second([](Configuration& c) { c.masses[1] = 0.0; }), Contains("has the mass 0"));
    CHECK(fault([](Configuration& c) { c.positions[1][2] = -1e7; }).is_lost);
    CHECK_FALSE(fault([](Configuration& c) { c.masses[1] = 0.0; }).is_lost);
}
