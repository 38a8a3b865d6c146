#include "ljmd/observables/statistics/known_quantities.hpp"

#include <catch2/catch.hpp>

using namespace ljmd;

TEST_CASE("quantities of samples and others are known by their names") {
    CHECK(symbol_of("temperature") == "T");
    CHECK(symbol_of("surface_tension") == "gamma");
    CHECK(symbol_of("of_my_own").empty());
    REQUIRE(find_quantity("viscosity") != nullptr);
    CHECK(std::string(find_quantity("viscosity")->unit) == "epsilon tau/sigma^3");
    CHECK(find_quantity("Viscosity") == nullptr);
}
