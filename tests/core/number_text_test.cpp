#include "core/number_text.hpp"

#include <cmath>
#include "catch.hpp"

using ljmd::without_negative_zero;

TEST_CASE("a zero has no sign, whatever follows it") {
    CHECK(without_negative_zero("-0") == "0");
    CHECK(without_negative_zero("-0.0000") == "0.0000");
    CHECK(without_negative_zero("-0.000(12)") == "0.000(12)");
    CHECK(without_negative_zero("-0.00 +- 0.15") == "0.00 +- 0.15");
    CHECK(without_negative_zero("-0e+00") == "0e+00");
    CHECK(without_negative_zero("-0 %") == "0 %");
    for (const char* other : {"-0.01", "-0.001(2)", "-1", "-10", "0", "-", "", "--", "-.5", "-x0", "-0.0001e-5"}) {
        CHECK(without_negative_zero(std::string(other)) == other);
    }
    CHECK_FALSE(std::signbit(without_negative_zero(-0.0)));
    CHECK(without_negative_zero(-1e-300) == -1e-300);
}
