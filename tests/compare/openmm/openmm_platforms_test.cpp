#include "compare/openmm/openmm_platforms.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "ljmd/compare/openmm.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

TEST_CASE("OpenMM is built in, and its platforms are loaded") {
    CHECK(openmm_is_built_in());
    CHECK(openmm_version() >= "7.7");
    const std::vector<std::string> names = openmm_platforms();
    for (const std::string name : {"Reference", "CPU"}) {
        CHECK(std::find(names.begin(), names.end(), name) != names.end());
        CHECK(openmm_platform(name).getName() == name);
    }
}

TEST_CASE("an unknown platform is told with those that are loaded, and where they were looked for") {
    CHECK_THROWS_AS(openmm_platform("Abacus"), InputError);
    CHECK_THROWS_WITH(openmm_platform("Abacus"), Contains("no platform 'Abacus'") && Contains("Reference") &&
                                                     Contains("CPU") && Contains("OPENMM_PLUGIN_DIR"));
}
