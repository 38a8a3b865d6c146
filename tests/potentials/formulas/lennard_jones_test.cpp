#include "ljmd/detail/potentials/formulas/lennard_jones.hpp"

#include "potentials/closed_form.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("Lennard-Jones has the energy and w of its closed form, with every truncation") {
    check_closed_form("lennard-jones", {},
                      {[](Real r) { return term(4.0L * std::pow(r, -12)) - term(4.0L * std::pow(r, -6)); },
                       [](Real r) { return term(24.0L * std::pow(r, -7)) - term(48.0L * std::pow(r, -13)); }});
}

TEST_CASE("Lennard-Jones: known values, and its repulsive half (Weeks, Chandler and Andersen)") {
    const double minimum = std::pow(2.0, 1.0 / 6.0);
    const auto cut = PairPotential::lennard_jones("cut", {2.5, 0.0});
    CHECK(cut(1.0).u == 0.0);
    CHECK(cut(1.0).w == 24.0);
    CHECK(cut(minimum).u == Approx(-1.0).epsilon(1e-15));
    CHECK(cut(minimum).w == Approx(0.0).margin(1e-13));
    CHECK(cut.untruncated(2.5).u == Approx(-0.016316891136).epsilon(1e-15));

    const auto wca = PairPotential::lennard_jones("shifted", {minimum, 0.0});
    for (const double r : distances(0.8, minimum, 500)) {
        CHECK(wca(r).u == Approx(cut(r).u + 1.0).epsilon(1e-14).margin(1e-14));
        CHECK(wca(r).u > -1e-15);
        CHECK(wca(r).w > -1e-13);
    }
}
