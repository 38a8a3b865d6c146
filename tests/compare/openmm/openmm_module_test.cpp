#include "compare/openmm_module.hpp"

#include <algorithm>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("the module has the platform that needs no plug-in, and skips what is none") {
    const OpenmmModule& openmm = *ljmd_openmm();
    openmm.load_plugin("/dev/null");
    openmm.load_plugin("/nowhere/libNothing.so");
    const std::vector<std::string> names = openmm.platforms();
    CHECK(std::find(names.begin(), names.end(), "Reference") != names.end());
    CHECK(openmm.version() == openmm_version());
    CHECK_FALSE(openmm.plugin_folder().empty());
}
