#include "integrators/barostat.hpp"

#include <algorithm>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"

using namespace ljmd;

TEST_CASE("barostats are listed by name, in alphabetical order, with a meaning") {
    const std::vector<std::string> names = plugin_names(all_barostats());
    CHECK(std::is_sorted(names.begin(), names.end()));
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    CHECK(std::find(names.begin(), names.end(), "stochastic-cell-rescaling") != names.end());
    for (const auto& method : all_barostats()) {
        CHECK_FALSE(method.meaning.empty());
        CHECK(find_barostat(method.name).name == method.name);
    }
    CHECK_THROWS_WITH(find_barostat("piston"), Catch::Contains("barostat") && Catch::Contains("piston"));
}
