// Row a of the physics ladder: pair energy and w of every formula and truncation against closed forms in long double,
// written a second time here, and against a difference of the energy.
#include "ljmd/potentials/pair_potential.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>

#include "ljmd/core/errors.hpp"
#include "potentials/made_potential.hpp"

using namespace ljmd;
using test::made_potential;

namespace {

using Real = long double;

/// A value and the sum of the absolute values of the terms that it was added up from: what its round-off is measured
/// by.
struct Sum {
    Real value = 0.0L;
    Real terms = 0.0L;
};
Sum term(Real value) {
    return {value, std::abs(value)};
}
Sum operator+(const Sum& a, const Sum& b) {
    return {a.value + b.value, a.terms + b.terms};
}
Sum operator-(const Sum& a, const Sum& b) {
    return {a.value - b.value, a.terms + b.terms};
}
Sum operator*(const Sum& a, const Sum& b) {
    return {a.value * b.value, a.terms * b.terms};
}
Sum operator/(const Sum& a, const Sum& b) {
    return {a.value / b.value, a.terms / std::abs(b.value)};
}

/// A formula in closed form: energy and its derivative u'(r).
struct ClosedForm {
    std::function<Sum(Real)> u;
    std::function<Sum(Real)> slope;
};

ClosedForm lennard_jones() {
    return {[](Real r) { return term(4.0L * std::pow(r, -12)) - term(4.0L * std::pow(r, -6)); },
            [](Real r) { return term(24.0L * std::pow(r, -7)) - term(48.0L * std::pow(r, -13)); }};
}

/// f(x), where x is itself a sum: the rounding of x, three operations at half an eps, counts as much as the slope of f
/// makes of it. Without this the gate is wrong where an argument, a (r - r0) or (r - rs)/(rc - rs), magnifies the
/// rounding of r: 11.7 eps were measured for Morse at r = 4, and 60 eps for the switch over a width of 0.1; with it 2
/// eps.
Sum function_of(const Sum& x, const Sum& f, Real slope) {
    constexpr Real share = 1.5L / 5.0L;
    return {f.value, f.terms + share * std::abs(slope) * x.terms};
}

ClosedForm morse(Real depth, Real steepness, Real minimum) {
    const auto exponential = [=](Real power, Real r) {
        const Sum x = term(power * steepness) * (term(r) - term(minimum));
        const Real value = std::exp(-x.value);
        return function_of(x, term(value), value);
    };
    return {[=](Real r) { return term(depth) * (exponential(2, r) - term(2) * exponential(1, r)); },
            [=](Real r) { return term(2 * depth * steepness) * (exponential(1, r) - exponential(2, r)); }};
}

/// u and w = -u'/r of a truncated formula.
struct Expected {
    Sum u, w;
};

Expected truncated(const ClosedForm& formula, const std::string& truncation, const Cutoff& cutoff, Real r) {
    const Real rc = cutoff.radius;
    const Sum u = formula.u(r);
    const Sum w = term(-1) * formula.slope(r) / term(r);
    if (truncation == "cut") {
        return {u, w};
    }
    if (truncation == "shifted") {
        return {u - formula.u(rc), w};
    }
    if (truncation == "force-shifted") {
        const Sum slope = formula.slope(rc);
        return {u - formula.u(rc) - (term(r) - term(rc)) * slope, w + slope / term(r)};
    }
    REQUIRE(truncation == "switched");  // a new truncation needs its closed form here
    const Real rs = cutoff.switch_start;
    if (r <= rs) {
        return {u, w};
    }
    const Real width = rc - rs;
    const Sum argument = (term(r) - term(rs)) / term(width);
    const Real x = argument.value;
    const Real ds = -30 * x * x * (1 - x) * (1 - x);
    const Sum s = function_of(
        argument, term(1) - term(10 * x * x * x) + term(15 * std::pow(x, 4)) - term(6 * std::pow(x, 5)), ds);
    const Sum slope = function_of(argument, term(ds), 60 * x * (1 - x) * (1 - 2 * x)) / term(width);
    return {u * s, w * s - u * slope / term(r)};
}

struct Setting {
    std::string formula;
    std::map<std::string, double> numbers;
    ClosedForm closed_form;
};

std::vector<Setting> settings() {
    return {{"lennard-jones", {}, lennard_jones()},
            {"morse", {}, morse(1.0L, 6.0L, 1.122462048309373)},
            {"morse",
             {{"well_depth", 2.5}, {"steepness", 4.3}, {"minimum", 1.31}},
             morse(2.5L, 4.3, 1.31)}};  // the doubles 4.3 and 1.31, not the decimal numbers
}

std::vector<Cutoff> cutoffs() {
    return {{2.5, 2.0}, {3.0, 2.9}, {std::pow(2.0, 1.0 / 6.0), 0.9}, {4.0, 0.85}};
}

/// Call check(potential, ...) for each formula with its defaults, each truncation and each cutoff.
void for_each_potential(const std::function<void(const PairPotential&)>& check) {
    for (const std::string& formula : PairPotential::formula_names()) {
        for (const std::string& truncation : PairPotential::truncation_names()) {
            for (const Cutoff& cutoff : cutoffs()) {
                INFO(formula << ", " << truncation << ", rc = " << cutoff.radius);
                check(made_potential(formula, truncation, cutoff));
            }
        }
    }
}

std::vector<double> distances(double low, double high, int count) {
    std::mt19937_64 generator(41);
    std::uniform_real_distribution<double> uniform(low, high);
    std::vector<double> all = {low, std::nextafter(high, 0.0)};
    for (int k = 0; k < count; ++k) {
        all.push_back(uniform(generator));
    }
    return all;
}

}  // namespace

TEST_CASE("energy and w agree with closed forms to 5 eps times the sum of absolute terms") {
    constexpr Real gate = 5.0L * std::numeric_limits<double>::epsilon();
    for (const Setting& setting : settings()) {
        for (const std::string& truncation : PairPotential::truncation_names()) {
            for (const Cutoff& cutoff : cutoffs()) {
                const auto potential = made_potential(setting.formula, truncation, cutoff, setting.numbers);
                Real worst_u = 0.0L;
                Real worst_w = 0.0L;
                for (const double r : distances(0.8, cutoff.radius, 5000)) {
                    const double r2 = r * r;
                    const auto found = potential.visit([r2](const auto& pair) { return pair_term(pair, r2); });
                    const Expected expected =
                        truncated(setting.closed_form, truncation, cutoff, std::sqrt(static_cast<Real>(r2)));
                    worst_u = std::max(worst_u, std::abs(found.u - expected.u.value) / expected.u.terms);
                    worst_w = std::max(worst_w, std::abs(found.w - expected.w.value) / expected.w.terms);
                }
                CAPTURE(setting.formula, truncation, cutoff.radius, worst_u / gate, worst_w / gate);
                CHECK(worst_u < gate);
                CHECK(worst_w < gate);
            }
        }
    }
}

TEST_CASE("every formula has a closed form in this test") {
    for (const std::string& formula : PairPotential::formula_names()) {
        const auto all = settings();
        CAPTURE(formula);
        CHECK(std::any_of(all.begin(), all.end(), [&](const Setting& s) { return s.formula == formula; }));
    }
}

TEST_CASE("the force is the slope of the energy, for every formula and truncation") {
    for_each_potential([](const PairPotential& potential) {
        constexpr double h = 1e-5;
        double largest = 0.0;
        double sum = 0.0;
        const auto all = distances(0.8 + h, potential.cutoff().radius - h, 2000);
        for (const double r : all) {
            const double force = potential(r).w * r;
            const double difference = (potential(r - h).u - potential(r + h).u) / (2.0 * h);
            largest = std::max(largest, std::abs(force - difference));
            sum += force * force;
        }
        const double rms = std::sqrt(sum / static_cast<double>(all.size()));
        CAPTURE(largest, rms);
        CHECK(largest < 1e-7 * rms);
    });
}

TEST_CASE("a pair at the cutoff or beyond contributes nothing, one within does") {
    for_each_potential([](const PairPotential& potential) {
        const double rc = potential.cutoff().radius;
        for (const double r :
             {rc, std::nextafter(rc, 10.0), 2.0 * rc, 1e300, std::numeric_limits<double>::infinity()}) {
            CHECK(potential(r).u == 0.0);
            CHECK(potential(r).w == 0.0);
        }
        CHECK(potential(0.8).w != 0.0);
        CHECK(potential.untruncated(1.5 * rc).u != 0.0);
        CHECK(potential.untruncated(1.5 * rc).w != 0.0);
    });
}

TEST_CASE("at the cutoff each truncation is as smooth as it says") {
    for_each_potential([](const PairPotential& potential) {
        const double rc = potential.cutoff().radius;
        const std::string& truncation = potential.truncation();
        const auto full = potential.untruncated(rc);
        // Sizes to compare with: a slope of the energy and a curvature near rc.
        const double slope = std::abs(potential.untruncated(0.999 * rc).w) * rc + std::abs(full.w) * rc + 1e-3;
        const double width = rc - potential.cutoff().switch_start;
        for (const double d : {1e-3, 1e-4, 1e-5, 1e-6}) {
            const auto inside = potential(rc - d);
            CAPTURE(d, inside.u, inside.w, full.u, full.w);
            if (truncation == "cut") {
                CHECK(inside.u == potential.untruncated(rc - d).u);
                CHECK(inside.w == potential.untruncated(rc - d).w);
            } else if (truncation == "shifted") {
                CHECK(std::abs(inside.u) < 2.0 * slope * d + 1e-14);
                CHECK(inside.w == potential.untruncated(rc - d).w);
            } else if (truncation == "force-shifted") {
                const double curvature = 500.0 * (slope + std::abs(full.u));  // 57 at the minimum of Lennard-Jones
                CHECK(std::abs(inside.u) < curvature * d * d + 1e-13);
                CHECK(std::abs(inside.w) < curvature * d + 1e-13);
            } else {
                // S = 10 y^3 + ..., S' = -30 y^2/width + ... in y = d / width
                const double y = d / width;
                const double size = 1.1 * (std::abs(potential.untruncated(rc - d).u) + slope * d);
                CHECK(std::abs(inside.u) < size * 10.0 * y * y * y + 1e-13);
                CHECK(std::abs(inside.w * rc) < size * 33.0 * y * y / width + slope * 10.0 * y * y * y + 1e-13);
                const double force_slope =
                    (inside.w * (rc - d) - potential(rc - 0.5 * d).w * (rc - 0.5 * d)) / (0.5 * d);
                CHECK(std::abs(force_slope) <
                      66.0 * size * y / (width * width) + 100.0 * slope * y * y / width + 1e-12 / d);
            }
        }
    });
}

TEST_CASE("below its start a switched potential is the formula, bit for bit") {
    for (const std::string& formula : PairPotential::formula_names()) {
        for (const Cutoff& cutoff : cutoffs()) {
            const auto potential = made_potential(formula, "switched", cutoff);
            CAPTURE(formula, cutoff.radius);
            for (const double r : distances(0.8, cutoff.switch_start, 500)) {
                REQUIRE(potential(r).u == potential.untruncated(r).u);
                REQUIRE(potential(r).w == potential.untruncated(r).w);
            }
            const double middle = 0.5 * (cutoff.switch_start + cutoff.radius);
            CHECK(potential(middle).u == Approx(0.5 * potential.untruncated(middle).u).epsilon(1e-12));  // S(1/2) = 1/2
        }
    }
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

TEST_CASE("Morse: depth, place and curvature of its minimum") {
    const auto morse = made_potential("morse", "cut", {3.0, 0.0}, {{"well_depth", 2.5}, {"minimum", 1.25}});
    CHECK(morse(1.25).u == -2.5);
    CHECK(morse(1.25).w == 0.0);
    CHECK(morse(1.2).w > 0.0);
    CHECK(morse(1.3).w < 0.0);
    constexpr double h = 1e-4;  // u'' = 2 D a^2
    CHECK((morse(1.25 + h).u + morse(1.25 - h).u + 5.0) / (h * h) == Approx(2.0 * 2.5 * 36.0).epsilon(1e-4));
}

TEST_CASE("a potential knows its names, keys and cutoff") {
    const auto formulas = PairPotential::formula_names();
    CHECK(std::count(formulas.begin(), formulas.end(), "lennard-jones") == 1);
    CHECK(std::count(formulas.begin(), formulas.end(), "morse") == 1);
    CHECK(PairPotential::truncation_names() == std::vector<std::string>{"cut", "shifted", "force-shifted", "switched"});
    for (const std::string& formula : formulas) {
        CHECK_FALSE(PairPotential::formula_meaning(formula).empty());
    }
    CHECK(PairPotential::formula_keys("lennard-jones").empty());
    CHECK(PairPotential::formula_keys("morse").size() == 3);
    Cutoff radii;
    Description keys;
    PairPotential::describe_truncation("cut", keys, radii);
    CHECK(keys.keys().empty());
    PairPotential::describe_truncation("switched", keys, radii);
    REQUIRE(keys.key_of(&radii.switch_start) != nullptr);
    CHECK(*keys.key_of(&radii.switch_start) == "switch_start");
    CHECK(PairPotential::takes_tail("cut"));
    CHECK(PairPotential::takes_tail("switched"));
    CHECK_FALSE(PairPotential::takes_tail("shifted"));
    CHECK_FALSE(PairPotential::takes_tail("force-shifted"));

    const auto potential = made_potential("morse", "switched", {2.5, 2.0});
    CHECK(potential.formula() == "morse");
    CHECK(potential.truncation() == "switched");
    CHECK(potential.cutoff().radius == 2.5);
    CHECK(potential.cutoff().switch_start == 2.0);
    const auto morse = made_potential("morse", "cut", {2.5}, {{"well_depth", 2.0}, {"minimum", 1.25}});
    CHECK(morse.parameters() ==
          std::vector<std::pair<std::string, double>>{{"well_depth", 2.0}, {"steepness", 6.0}, {"minimum", 1.25}});
    CHECK(PairPotential::lennard_jones("cut", {2.5}).parameters().empty());

    const auto from_deck = made_potential("lennard-jones", "switched", {2.5, 2.0});
    const auto direct = PairPotential::lennard_jones("switched", {2.5, 2.0});
    CHECK(direct.formula() == "lennard-jones");
    CHECK(direct(2.3).u == from_deck(2.3).u);
    CHECK(direct(2.3).w == from_deck(2.3).w);
}

TEST_CASE("unknown names are refused or have nothing") {
    CHECK_THROWS_AS(PairPotential::lennard_jones("smooth", {2.5, 2.0}), InputError);
    CHECK_THROWS_WITH(PairPotential::lennard_jones("smooth", {2.5, 2.0}),
                      "unknown truncation 'smooth', allowed: cut, shifted, force-shifted, switched");
    CHECK_THROWS_AS(made_potential("buckingham", "cut", {2.5, 2.0}), ContractViolation);
    CHECK_THROWS_AS(made_potential("morse", "smooth", {2.5, 2.0}), InputError);
    CHECK(PairPotential::formula_meaning("buckingham").empty());
    CHECK(PairPotential::formula_keys("buckingham").empty());
    Cutoff radii;
    Description keys;
    PairPotential::describe_truncation("smooth", keys, radii);
    CHECK(keys.keys().empty());
    CHECK_FALSE(PairPotential::takes_tail("smooth"));
}
