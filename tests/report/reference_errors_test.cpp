#include "report/reference_errors.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

using namespace ljmd;

namespace {

/// Bins of 0.001 from 0 to `last`, with g beyond the cutoff.
DataTable rdf(double beyond, double cutoff, double last) {
    DataTable table{"rdf", {"r", "g", "g_standard_error"}, {}};
    for (double r = 0.0005; r < last; r += 0.001) {
        table.rows.push_back({r, r < cutoff ? 7.0 : beyond, 0.0});
    }
    return table;
}

}  // namespace

TEST_CASE("beyond the cutoff the tail correction is right where g is 1, and off in proportion to g - 1") {
    CHECK(beyond_cutoff(rdf(1.0, 2.5, 5.0), 2.5, 0.8)->energy == Approx(0.0).margin(1e-12));
    CHECK(beyond_cutoff(rdf(1.0, 2.5, 5.0), 2.5, 0.8)->pressure == Approx(0.0).margin(1e-12));
    // The integrals of r^2 phi and r^3 phi' from 2.5 to 5 in closed form.
    const double energy = [] {
        const auto antiderivative = [](double r) { return 4.0 * (-std::pow(r, -9) / 9.0 + std::pow(r, -3) / 3.0); };
        return 2.0 * std::numbers::pi * 0.8 * 0.1 * (antiderivative(5.0) - antiderivative(2.5));
    }();
    const double pressure = [] {
        const auto antiderivative = [](double r) {
            return 24.0 * (-2.0 * std::pow(r, -9) / 9.0 + std::pow(r, -3) / 3.0);
        };
        return 2.0 / 3.0 * std::numbers::pi * 0.8 * 0.8 * 0.1 * (antiderivative(5.0) - antiderivative(2.5));
    }();
    const auto found = beyond_cutoff(rdf(1.1, 2.5, 5.0), 2.5, 0.8);
    REQUIRE(found);
    CHECK(found->energy == Approx(energy).epsilon(1e-4));
    CHECK(found->pressure == Approx(pressure).epsilon(1e-4));
    CHECK(found->energy < 0.0);
}

TEST_CASE("nothing is known where g ends soon after the cutoff, or in a table of something else") {
    CHECK_FALSE(beyond_cutoff(rdf(1.1, 2.5, 3.4), 2.5, 0.8));
    CHECK(beyond_cutoff(rdf(1.1, 2.5, 3.6), 2.5, 0.8));
    CHECK_FALSE(beyond_cutoff({"sk", {"k", "S"}, {{1.0, 1.0}, {2.0, 1.0}}}, 2.5, 0.8));
    CHECK_FALSE(beyond_cutoff({"rdf", {"r", "g"}, {}}, 2.5, 0.8));
}

TEST_CASE("equations of the same fluid differ where others hold") {
    const EquationOfState thol = equation_of_state("thol2016");
    const double found = difference_of_equations(thol, 1.5, 0.7, &FluidProperties::pressure);
    const double kolafa = properties(equation_of_state("kolafa-nezbeda1994"), 1.5, 0.7).pressure;
    CHECK(found >= std::abs(kolafa - properties(thol, 1.5, 0.7).pressure));
    CHECK(found > 0.0);
    CHECK(found < 0.05);
    CHECK(difference_of_equations(equation_of_state("thol2015"), 1.5, 0.7, &FluidProperties::pressure) == 0.0);
}
