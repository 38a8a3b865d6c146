#include "ljmd/detail/observables/statistics/observable_average.hpp"

#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("the table leaves out components of the pressure tensor and the virial, and nothing else") {
    const auto in_table = [](const std::string& name, bool own) {
        return is_in_table({.name = name, .symbol = "", .unit = "", .estimate = std::nullopt, .own = own});
    };
    CHECK(in_table("pressure", false));
    CHECK(in_table("diffusion_green_kubo", false));
    CHECK_FALSE(in_table("pressure_xy", false));
    CHECK_FALSE(in_table("virial", false));
    CHECK(in_table("pressure_over_temperature", true));
}

TEST_CASE("error bars that are guesses are named, unless all are") {
    const auto average = [](const std::string& name, bool converged) {
        Estimate estimate{};
        estimate.standard_error = 0.1;
        estimate.converged = converged;
        return ObservableAverage{name, "x", "1", estimate};
    };
    const ObservableAverage known = average("temperature", true);
    const ObservableAverage few = average("pressure", false);
    const ObservableAverage short_one = average("diffusion", false);
    CHECK(unsure_of({known}).empty());
    CHECK(unsure_of({known, few, short_one}) == "pressure, diffusion");
    CHECK(unsure_of({few, short_one}) == "all observables");
    ObservableAverage conserved = known;
    conserved.estimate->independent_samples = std::numeric_limits<double>::quiet_NaN();
    CHECK(unsure_of({conserved, few, short_one}) == "all observables");
    CHECK(unsure_of({conserved, known, few}) == "pressure");
    CHECK(unsure_of({}).empty());
    CHECK(unsure_of({known, average("pressure_xx", false)}).empty());
    CHECK(unsure_of({{"temperature", "T", "1", std::nullopt}}).empty());
}

TEST_CASE("a guessed error is a remark beside others, and no remark where no error is given") {
    ObservableAverage pressure{"pressure", "p", "1", Estimate{1.0, 0.1, 5.0, 100, false}};
    CHECK(remark_of(pressure) == guessed_error);
    pressure.remark = "asked for 1.0";
    CHECK(remark_of(pressure) == "asked for 1.0; " + std::string(guessed_error));
    pressure.estimate->standard_error = std::numeric_limits<double>::quiet_NaN();
    CHECK(remark_of(pressure) == "asked for 1.0");
}
