#include "study/reference/reference_length.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

using namespace ljmd;

namespace {

ReferenceValue measured(const std::string& name, double mean, double error, double independent) {
    return {.name = name,
            .symbol = "",
            .unit = "1",
            .mean = mean,
            .statistical_error = error,
            .systematic_error = 0.0,
            .independent = independent};
}

}  // namespace

TEST_CASE("an error is reached when it is small enough, from enough samples, and no guess") {
    const auto reached = [](const ReferenceValue& value) {
        return reached_errors({{"pressure", 0.01}}, {value}).at(0).reached;
    };
    CHECK(reached(measured("pressure", 1.0, 0.01, 150)));
    CHECK_FALSE(reached(measured("pressure", 1.0, 0.0101, 150)));
    CHECK_FALSE(reached(measured("pressure", 1.0, 0.01, 149)));
    ReferenceValue guess = measured("pressure", 1.0, 0.01, 150);
    guess.converged = false;
    CHECK_FALSE(reached(guess));
    ReferenceValue none = measured("pressure", 1.0, 0.01, 150);
    none.mean.reset();
    CHECK_FALSE(reached(none));
}

TEST_CASE("nothing is waited for that no length of the runs gives") {
    ReferenceValue value{
        .name = "viscosity", .symbol = "", .unit = "1", .statistical_error = 0.0, .systematic_error = 0.0};
    CHECK(reached_errors({}, {value}).size() == 1);
    value.withheld = true;
    CHECK(reached_errors({{"viscosity", 0.01}}, {value}).empty());
}

TEST_CASE("properties without a wanted error reach a part of their value, and some are not waited for") {
    const auto errors = reached_errors(
        {}, {measured("heat_capacity_cv", 2.0, 0.09, 400), measured("excess_chemical_potential", -2.0, 1.0, 400),
             measured("viscosity", 2.0, 0.3, 400)});
    REQUIRE(errors.size() == 2);
    CHECK(errors[0].wanted.error == Approx(0.1));
    CHECK(errors[0].reached);
    CHECK(errors[1].wanted.error == Approx(0.2));
    CHECK_FALSE(errors[1].reached);
}

TEST_CASE("runs grow by what their largest error needs, by sqrt(2) at least and by 8 at most") {
    const auto next = [](double error, Index steps, Index most = 1'000'000) {
        return next_length({{{"pressure", 0.01}, error, error <= 0.01}, {{"potential_energy", 1.0}, 0.5, true}}, steps,
                           most);
    };
    CHECK_FALSE(next(0.009, 10'000));
    CHECK(next(0.02, 10'000) == 44'000);    // 1.1 x 4
    CHECK(next(0.0101, 10'000) == 15'000);  // sqrt(2), rounded up
    CHECK(next(0.5, 10'000) == 80'000);
    CHECK(next(std::numeric_limits<double>::quiet_NaN(), 10'000) == 20'000);
    CHECK(next(0.5, 10'000, 50'000) == 50'000);
    CHECK_FALSE(next(0.5, 50'000, 50'000));
}
