#include "report/quantity_names.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("columns have symbols and units, errors those of their quantity") {
    CHECK(described("pressure").label == "p");
    CHECK(described("pressure").unit == "epsilon/sigma^3");
    CHECK(described("pressure_standard_error").name == "pressure_standard_error");
    CHECK(described("pressure_standard_error").label == "error of p");
    CHECK(described("of_my_own").label == "of my own");
    CHECK(as_title("potential_energy") == "Potential energy");
}

TEST_CASE("the label of an axis has the unit, in brackets where it has several parts") {
    CHECK(axis_label("time") == "t / tau");
    CHECK(axis_label("pressure") == "p / (epsilon/sigma^3)");
    CHECK(axis_label("g") == "g(r)");
}
