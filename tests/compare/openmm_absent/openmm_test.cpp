#include "ljmd/compare/openmm.hpp"

#include <catch2/catch.hpp>

#include "compare/small_fluid.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a build without OpenMM says so") {
    CHECK_FALSE(openmm_is_built_in());
    CHECK(openmm_version().empty());
    CHECK(openmm_platforms().empty());
    CHECK_THROWS_AS(make_openmm_peer(small_fluid(), {}), InputError);
    CHECK_THROWS_WITH(make_openmm_peer(small_fluid(), {}), Contains("built without OpenMM"));
    CHECK_THROWS_WITH(openmm_xml(small_fluid(), 0.004), Contains("built without OpenMM"));
}
