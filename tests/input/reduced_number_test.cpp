#include "input/reduced_number.hpp"

#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

TEST_CASE("numbers are numbers, and what else they are is not asked") {
    for (const char* number : {"1", "-1.5", "1e-3", "+2", "nan", "inf", " 3"}) {
        INFO(number);
        CHECK(not_reduced(number, "tau", Dimension::time).empty());
    }
}

TEST_CASE("a quantity with a unit is told in reduced units of argon") {
    const std::string kelvin = not_reduced("120K", "epsilon/k_B", Dimension::temperature);
    CHECK_THAT(kelvin, Contains("'120K' is no number") && Contains("reduced units, epsilon/k_B, without a unit") &&
                           Contains("for argon (sigma = 3.405 angstrom") && Contains("it is 1.00167"));
    CHECK_THAT(not_reduced("1.374 g/cm3", "atoms per sigma^3", Dimension::density), Contains("it is 0.8177"));
    CHECK_THAT(not_reduced("10 fs", "tau", Dimension::time), Contains("it is 0.0046"));
}

TEST_CASE("what is no quantity, or one of another dimension, is refused without one") {
    for (const char* text : {"hot", "", "120 bar", "1.2.3", "120 K K"}) {
        const std::string why = not_reduced(text, "epsilon/k_B", Dimension::temperature);
        CHECK_THAT(why, Contains("is no number") && !Contains("argon"));
    }
}
