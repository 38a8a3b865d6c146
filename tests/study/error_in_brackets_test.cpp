#include "study/error_in_brackets.hpp"

#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("the error has two digits, in units of the last ones of the value") {
    CHECK(with_error_in_brackets(0.9571, 0.0138) == "0.957(14)");
    CHECK(with_error_in_brackets(0.5, 1e-17) == "0.500000000000000(1)");
    CHECK(with_error_in_brackets(-6.05472, 0.00171) == "-6.0547(17)");
    CHECK(with_error_in_brackets(0.9571, 0.0994) == "0.957(99)");
    CHECK(with_error_in_brackets(0.9571, 0.0996) == "0.96(10)");
    CHECK(with_error_in_brackets(123.4, 5.6) == "123.4(56)");
    CHECK(with_error_in_brackets(1234.0, 56.0) == "1234(56)");
    CHECK(with_error_in_brackets(-0.0002, 0.012) == "0.000(12)");
}

TEST_CASE("without an error there are no brackets") {
    CHECK(with_error_in_brackets(0.9571, 0.0) == "0.9571");
    CHECK(with_error_in_brackets(0.9571, std::numeric_limits<double>::quiet_NaN()) == "0.9571");
    CHECK(with_error_in_brackets(0.9571, std::numeric_limits<double>::infinity()) == "0.9571");
}
