#include "observables/transport/green_kubo.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

using namespace ljmd;

namespace {

ObservableAverage integral(double mean, double error, Index windows, double independent, bool converged = false) {
    return {"viscosity", "eta", "", Estimate{mean, error, independent, windows, converged}};
}

}  // namespace

TEST_CASE("the change at twice the spacing is that of the trapezoidal rule") {
    Eigen::VectorXd values(5);
    values << 4.0, 3.0, 1.0, 0.5, 0.25;
    // 2 (4/2 + 1 + 0.25/2) - (4/2 + 3 + 1 + 0.5 + 0.25/2)
    CHECK(change_at_double_spacing(values, 0.1) == Approx(0.1 * (6.25 - 6.625)).epsilon(1e-14));
    CHECK(change_at_double_spacing(values.head(4), 0.1) == Approx(change_at_double_spacing(values.head(3), 0.1)));
    CHECK(std::isnan(change_at_double_spacing(values.head(2), 0.1)));
    const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(7, 3.0, 0.0);
    CHECK(change_at_double_spacing(line, 0.1) == Approx(0.0).margin(1e-15));
}

TEST_CASE("an integral that changes by more than its error with every second frame has no value") {
    CHECK(green_kubo_integral(integral(2.0, 0.1, 40, 40.0), -0.09).estimate->mean == 2.0);
    const ObservableAverage coarse = green_kubo_integral(integral(2.0, 0.1, 40, 40.0), 0.11);
    CHECK_FALSE(coarse.estimate.has_value());
    CHECK(coarse.remark == "configurations are too far apart in time: with every second one the integral is another");
    CHECK_FALSE(green_kubo_integral(integral(2.0, 0.1, 40, 40.0), std::nan("")).estimate.has_value());
    // Where nothing fluctuates rounding is left.
    CHECK(green_kubo_integral(integral(2.0, 0.0, 40, 40.0), 4e-16).estimate.has_value());
    // Without an error a twentieth of the integral counts.
    CHECK(green_kubo_integral(integral(2.0, std::nan(""), 2, std::nan("")), 0.09).estimate.has_value());
    CHECK_FALSE(green_kubo_integral(integral(2.0, std::nan(""), 2, std::nan("")), 0.11).estimate.has_value());
}

TEST_CASE("an integral over few windows is marked as every series is") {
    CHECK_FALSE(green_kubo_integral(integral(2.0, 0.1, 8, 8.0, false), 0.0).estimate->converged);
    CHECK_FALSE(green_kubo_integral(integral(2.0, 0.1, 30, 12.0, false), 0.0).estimate->converged);
    CHECK(green_kubo_integral(integral(2.0, 0.1, 300, 100.0, true), 0.0).estimate->converged);
}
