#include "io/tables/thermo_columns.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("the history of a fluid has a number in each of its columns, NaN where a quantity is not defined") {
    Thermodynamics sample;
    sample.potential_energy = -6.0;
    sample.kinetic_energy = 1.5;
    sample.total_energy = -4.5;
    sample.density = 0.8;
    sample.edges = Vec3(5.0, 6.0, 7.0);
    sample.external_energy = 0.25;
    const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
    const bool extra = GENERATE(false, true);
    const auto units = GENERATE_REF(as<std::optional<SubstanceUnits>>(), std::nullopt, std::optional(argon));
    const ThermoColumns columns({.density = extra,
                                 .edges = extra,
                                 .external_energy = extra,
                                 .conserved_energy = extra,
                                 .order_parameter = extra},
                                units);
    const std::vector<std::string> names = columns.names();
    const std::vector<double> row = columns.row(7, 0.25, sample, {std::nullopt, 0.5});
    REQUIRE(row.size() == names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        INFO(names[k]);
        const bool undefined =
            names[k].starts_with("temperature") || names[k].starts_with("pressure") || names[k] == "conserved_energy";
        CHECK(std::isnan(row[k]) == undefined);
    }
    CHECK(std::vector(row.begin(), row.begin() + 2) == std::vector{7.0, 0.25});
    CHECK(std::vector(row.begin() + 3, row.begin() + 6) == std::vector{-6.0, 1.5, -4.5});
    if (extra) {
        CHECK(row[13] == 0.8);
        CHECK(std::vector(row.begin() + 14, row.begin() + 17) == std::vector{5.0, 6.0, 7.0});
        CHECK(row[17] == 0.25);
        CHECK(row[19] == 0.5);
    }
    if (units) {
        CHECK(row[names.size() - 6] == 0.25 * argon.picosecond());
    }
}
