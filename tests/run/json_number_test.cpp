#include "ljmd/run/json_number.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace ljmd;

TEST_CASE("what JSON has no number for is null") {
    CHECK(number_or_null(0.1 + 0.2).get<double>() == 0.1 + 0.2);
    CHECK(number_or_null(0.0) == nlohmann::ordered_json(0.0));
    CHECK(number_or_null(std::nullopt).is_null());
    CHECK(number_or_null(std::numeric_limits<double>::quiet_NaN()).is_null());
    CHECK(number_or_null(-std::numeric_limits<double>::infinity()).is_null());
}
