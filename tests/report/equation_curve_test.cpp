#include "report/equation_curve.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/detail/reference/equation_of_state.hpp"

using namespace ljmd;

namespace {

std::vector<double> numbers(const PageTable& table, const std::string& name) {
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        if (table.columns[column].name == name) {
            std::vector<double> found;
            for (const Data& value : table.values[column]) {
                found.push_back(value.is_number() ? value.number() : std::nan(""));
            }
            return found;
        }
    }
    FAIL("no column " << name);
    return {};
}

}  // namespace

TEST_CASE("a curve goes through the states between points, in small steps, and has what the equation has there") {
    const PageTable table =
        equation_curves("temperature", {{1.5, 1.5, 0.01, 0.7, "thol2016", ""}, {2.5, 2.5, 0.01, 0.7, "thol2016", ""}});
    const auto places = numbers(table, "temperature");
    const auto pressures = numbers(table, "pressure_reference");
    REQUIRE(places.size() > 30);
    CHECK(places.front() == 1.5);
    CHECK(places.back() == 2.5);
    const EquationOfState equation = equation_of_state("thol2016");
    for (std::size_t k = 0; k < places.size(); ++k) {
        CHECK(pressures[k] == Approx(properties(equation, places[k], 0.7).pressure).epsilon(1e-8));
    }
}

TEST_CASE("each series has its own curve, and none joins points that are alone or of other fluids") {
    const PageTable table = equation_curves("x", {{1.0, 2.0, 0.01, 0.5, "thol2016", "a"},
                                                  {2.0, 2.0, 0.01, 0.6, "thol2016", "a"},
                                                  {1.0, 1.5, 0.01, 0.5, "thol2016", "b"},
                                                  {1.0, 1.5, 0.01, 0.5, "thol2016", "c"},
                                                  {2.0, 1.5, 0.01, 0.5, "thol2015", "c"},
                                                  {3.0, std::nan(""), 0.01, 0.5, "thol2016", "a"}});
    const auto column = [&](const std::string& name) {
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            if (table.columns[k].name == name) {
                return table.values[k];
            }
        }
        return Data::List();
    };
    REQUIRE_FALSE(column("series").empty());
    for (const Data& name : column("series")) {
        CHECK(name.text() == "a");
    }
    CHECK(numbers(table, "x").back() == 2.0);
    CHECK(equation_curves("x", {{1.0, 2.0, 0.01, 0.5, "", ""}, {2.0, 2.0, 0.01, 0.6, "", ""}}).columns.empty());
}

TEST_CASE("between gas and liquid a curve has no value") {
    const PageTable table =
        equation_curves("rho", {{0.01, 0.8, 0.01, 0.01, "thol2016", ""}, {0.8, 0.8, 0.01, 0.8, "thol2016", ""}});
    const auto pressures = numbers(table, "pressure_reference");
    CHECK(std::isfinite(pressures.back()));
    CHECK(std::isnan(pressures[pressures.size() / 2]));
}

TEST_CASE("along an isotherm a curve does not follow the noise of temperatures that agree") {
    const std::vector<StateOnAxis> isotherm{{0.5, 1.51, 0.02, 0.5, "thol2016", ""},
                                            {0.6, 1.48, 0.01, 0.6, "thol2016", ""}};
    const double mean = (1.51 + 4.0 * 1.48) / 5.0;
    const EquationOfState equation = equation_of_state("thol2016");
    CHECK(numbers(equation_curves("density", isotherm), "pressure_reference").front() ==
          Approx(properties(equation, mean, 0.5).pressure).epsilon(1e-8));
    auto apart = isotherm;
    apart[0].temperature = 1.6;
    auto unknown = isotherm;
    unknown[0].temperature_error = std::nan("");
    for (const auto& states : {apart, unknown}) {
        CHECK(numbers(equation_curves("density", states), "pressure_reference").front() ==
              Approx(properties(equation, states[0].temperature, 0.5).pressure).epsilon(1e-8));
    }
    CHECK(numbers(equation_curves("temperature", isotherm), "pressure_reference").front() ==
          Approx(properties(equation, 1.51, 0.5).pressure).epsilon(1e-8));
}
