#include "compare/openmm.hpp"

#include <algorithm>
#include "catch.hpp"

#include "compare/openmm_expression.hpp"
#include "compare/openmm_module.hpp"
#include "compare/peers.hpp"
#include "compare/small_fluid.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("OpenMM is loaded with its platforms, or it is said that it is not there") {
    CHECK(openmm_module().filename() == "ljmd_openmm.so");
    if (!openmm_is_here()) {
        CHECK_THROWS_AS(openmm_version(), InputError);
        CHECK_THROWS_WITH(make_openmm_peer(small_fluid(), {}), Contains("built without OpenMM"));
        CHECK_THROWS_WITH(openmm_xml(small_fluid(), 0.004), Contains("built without OpenMM"));
        return;
    }
    CHECK(openmm_version() >= "7.7");
    const std::vector<std::string> names = openmm_platforms();
    for (const std::string name : {"Reference", "CPU"}) {
        CHECK(std::find(names.begin(), names.end(), name) != names.end());
    }
}

TEST_CASE("an unknown platform is told with those that are loaded, and where they were looked for") {
    if (openmm_is_here()) {
        CHECK_THROWS_AS(make_openmm_peer(small_fluid(), {.platform = "Abacus"}), InputError);
        CHECK_THROWS_WITH(make_openmm_peer(small_fluid(), {.platform = "Abacus"}),
                          Contains("no platform 'Abacus'") && Contains("Reference") && Contains("CPU") &&
                              Contains("OPENMM_PLUGIN_DIR"));
    }
}

TEST_CASE("errors of the module are caught as those of the program") {
    if (openmm_is_here()) {
        Fluid fluid = small_fluid();
        fluid.edges = Vec3(6.0, 4.9, 8.0);
        CHECK_THROWS_AS(make_openmm_peer(fluid, {}), InputError);
        CHECK_THROWS_AS(make_openmm_peer(small_fluid(), {})->follow("no method", 0.004, {1}), ContractViolation);
    }
}

TEST_CASE("the module is told what only the program knows of a potential") {
    const Fluid fluid = small_fluid("morse", "shifted");
    const OpenmmFluid told = openmm_fluid(fluid);
    CHECK(told.positions == fluid.positions);
    CHECK(told.expression == openmm_expression(fluid.potential));
    CHECK(told.formula == openmm_formula(fluid.potential));
    CHECK(told.at_cutoff.u == fluid.potential.untruncated(2.5).u);
    CHECK(told.at_cutoff.w == fluid.potential.untruncated(2.5).w);
}
