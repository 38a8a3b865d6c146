#include "observables/statistics/interval_mean.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("The mean interval and its standard error follow from the marks") {
    const auto mean = mean_interval({1.0, 3.0, 6.0, 7.0});  // intervals 2, 3, 1
    REQUIRE(mean);
    CHECK(mean->mean == 2.0);
    CHECK(mean->standard_error == Approx(std::sqrt(2.0 / (3.0 * 2.0))).epsilon(1e-15));
    CHECK(mean->intervals == 3);
}

TEST_CASE("One interval has a mean and no error, one mark has neither") {
    const auto mean = mean_interval({1.0, 3.5});
    REQUIRE(mean);
    CHECK(mean->mean == 2.5);
    CHECK(std::isnan(mean->standard_error));
    CHECK(mean->intervals == 1);
    CHECK_FALSE(mean_interval({1.0}));
    CHECK_FALSE(mean_interval({}));
}

TEST_CASE("Of two means that with the smaller error is the better known, without errors that of more intervals") {
    const IntervalMean sharp{1.0, 0.1, 4};
    const IntervalMean blunt{2.0, 0.2, 5};
    const IntervalMean single{3.0, std::numeric_limits<double>::quiet_NaN(), 1};
    CHECK(better_known(sharp, blunt)->mean == 1.0);
    CHECK(better_known(blunt, sharp)->mean == 1.0);
    CHECK(better_known(single, blunt)->mean == 2.0);
    CHECK(better_known(blunt, single)->mean == 2.0);
    CHECK(better_known(single, IntervalMean{4.0, single.standard_error, 1})->mean == 4.0);
    CHECK(better_known(std::nullopt, single)->mean == 3.0);
    CHECK(better_known(single, std::nullopt)->mean == 3.0);
    CHECK_FALSE(better_known(std::nullopt, std::nullopt));
}
