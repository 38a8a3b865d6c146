#include "ljmd/detail/potentials/formulas/morse.hpp"

#include "potentials/closed_form.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

ClosedForm morse(Real depth, Real steepness, Real minimum) {
    const auto exponential = [=](Real power, Real r) {
        const Sum x = term(power * steepness) * (term(r) - term(minimum));
        const Real value = std::exp(-x.value);
        return function_of(x, term(value), value);
    };
    return {[=](Real r) { return term(depth) * (exponential(2, r) - term(2) * exponential(1, r)); },
            [=](Real r) { return term(2 * depth * steepness) * (exponential(1, r) - exponential(2, r)); }};
}

}  // namespace

TEST_CASE("Morse has the energy and w of its closed form, with every truncation") {
    const std::map<std::string, double> usual{{"well_depth", 1.0}, {"steepness", 6.0}, {"minimum", 1.122462048309373}};
    check_closed_form("morse", usual, morse(1.0L, 6.0L, 1.122462048309373));
    // the doubles 4.3 and 1.31, not the decimal numbers
    check_closed_form("morse", {{"well_depth", 2.5}, {"steepness", 4.3}, {"minimum", 1.31}}, morse(2.5L, 4.3, 1.31));
}

TEST_CASE("Morse: depth, place and curvature of its minimum") {
    const auto morse = made_potential("morse", "cut", {3.0, 0.0}, {{"well_depth", 2.5}, {"minimum", 1.25}});
    CHECK(morse(1.25).u == -2.5);
    CHECK(morse(1.25).w == 0.0);
    CHECK(morse(1.2).w > 0.0);
    CHECK(morse(1.3).w < 0.0);
    constexpr double h = 1e-4;  // u'' = 2 D a^2
    CHECK((morse(1.25 + h).u + morse(1.25 - h).u + 5.0) / (h * h) == Approx(2.0 * 2.5 * 36.0).epsilon(1e-4));
}
