#include "observables/statistics/known_quantities.hpp"

#include <algorithm>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/analysis.hpp"

using namespace ljmd;

TEST_CASE("quantities of samples and others are known by their names") {
    CHECK(symbol_of("temperature") == "T");
    CHECK(symbol_of("surface_tension") == "gamma");
    CHECK(symbol_of("of_my_own").empty());
    REQUIRE(find_quantity("viscosity") != nullptr);
    CHECK(std::string(find_quantity("viscosity")->unit) == "epsilon tau/sigma^3");
    CHECK(find_quantity("Viscosity") == nullptr);
}

TEST_CASE("an average has the symbol and the unit of its quantity") {
    const ObservableAverage density = average_of("vapour_density", std::nullopt, "why");
    CHECK(density.symbol == "rho_v");
    CHECK(density.unit == "sigma^-3");
    CHECK(density.remark == "why");
    CHECK_FALSE(density.estimate);
    CHECK(average_of("compressibility_factor").unit == "1");
    CHECK_THROWS_AS(average_of("vapor_density"), ContractViolation);
}

TEST_CASE("what an analysis finds has one symbol and one unit, and its charts are of its own tables") {
    for (const AnalysisMethod& method : all_analyses()) {
        INFO(method.name);
        for (const KnownQuantity& quantity : method.quantities) {
            INFO(quantity.name);
            const KnownQuantity* known = find_quantity(quantity.name);
            REQUIRE(known != nullptr);
            CHECK(std::string(known->symbol) == quantity.symbol);
            CHECK(std::string(known->unit) == quantity.unit);
        }
        for (const AnalysisChart& chart : method.charts) {
            INFO(chart.file);
            CHECK(std::ranges::find(method.files, chart.file) != method.files.end());
            for (const std::string column : {chart.x, chart.y}) {
                CHECK(find_quantity(column) != nullptr);
            }
        }
    }
}
