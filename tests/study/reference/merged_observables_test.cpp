#include "study/reference/merged_observables.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "study/reference/made_reference.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("merged observables are found by name, and those without a value are not") {
    const MadeUpReplicas replicas({-5.0}, {1.0}, 1.2);
    replicas.merged_results(
        observable("pressure", 1.5, 0.1, "epsilon/sigma^3") +
        R"(, "viscosity": {"mean": null, "standard_error": null, "unit": "x", "remark": "too short"})");
    const auto all = merged_observables(replicas.folder().merged);
    REQUIRE(all.size() == 2);
    const MergedObservable* pressure = find_merged(all, "pressure");
    REQUIRE(pressure != nullptr);
    CHECK(pressure->mean == 1.5);
    CHECK(pressure->standard_error == 0.1);
    CHECK(pressure->unit == "epsilon/sigma^3");
    CHECK(pressure->independent == 1000);
    CHECK(pressure->converged);
    CHECK(find_merged(all, "viscosity") == nullptr);
    CHECK(all[1].remark == "too short");
    CHECK(std::isnan(all[1].standard_error));
    CHECK_FALSE(all[1].converged);
    CHECK(find_merged(all, "density") == nullptr);
}

TEST_CASE("results that are damaged are named") {
    const MadeUpReplicas replicas({-5.0}, {1.0}, 1.2);
    CHECK_THROWS_AS(merged_observables(replicas.folder().merged), DataError);
    replicas.merged_results(R"("pressure": 3)");
    CHECK_THROWS_AS(merged_observables(replicas.folder().merged), DataError);
}
