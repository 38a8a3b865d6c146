// What is true of every formula and truncation. The closed form of each formula is in tests/potentials/formulas.
#include "ljmd/potentials/pair_potential.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "potentials/closed_form.hpp"
#include "potentials/made_potential.hpp"
#include "potentials/twelve_six.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using test::cutoffs;
using test::distances;
using test::made_potential;

namespace {

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

}  // namespace

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
    CHECK_THROWS_AS(made_potential("no such formula", "cut", {2.5, 2.0}), InputError);
    CHECK_THROWS_WITH(made_potential("no such formula", "cut", {2.5, 2.0}),
                      Contains("unknown potential 'no such formula', allowed: ") && Contains("lennard-jones"));
    CHECK_THROWS_AS(made_potential("morse", "smooth", {2.5, 2.0}), InputError);
    CHECK(PairPotential::formula_meaning("no such formula").empty());
    CHECK(PairPotential::formula_keys("no such formula").empty());
    Cutoff radii;
    Description keys;
    PairPotential::describe_truncation("smooth", keys, radii);
    CHECK(keys.keys().empty());
    CHECK_FALSE(PairPotential::takes_tail("smooth"));
}

TEST_CASE("parameters that are missing, unknown, given twice or out of range are refused in one message") {
    const auto morse = [](const PairPotential::Parameters& parameters) {
        return PairPotential::make("morse", "cut", {2.5, 0.0}, parameters);
    };
    const PairPotential::Parameters good{{"minimum", 1.1}, {"well_depth", 1.0}, {"steepness", 6.0}};
    CHECK(morse(good)(1.1).u == -1.0);
    CHECK_THROWS_AS(morse({}), InputError);
    CHECK_THROWS_WITH(morse({}), Contains("missing key 'well_depth' in morse") && Contains("missing key 'minimum'"));
    CHECK_THROWS_WITH(morse({{"minimum", 1.1}, {"well_depth", 1.0}, {"stepness", 6.0}}),
                      Contains("unknown key 'stepness' in morse: did you mean 'steepness'?"));
    CHECK_THROWS_WITH(morse({{"minimum", 1.1}, {"well_depth", 1.0}, {"steepness", 6.0}, {"steepness", 5.0}}),
                      Contains("'steepness' in morse is given twice"));
    CHECK_THROWS_WITH(morse({{"minimum", 1.1}, {"well_depth", -1.0}, {"steepness", 6.0}}),
                      Contains("'well_depth' in morse is -1") && Contains("> 0"));
    CHECK_THROWS_WITH(morse({{"minimum", std::nan("")}, {"well_depth", 1.0}, {"steepness", 6.0}}),
                      Contains("'minimum' in morse"));
    CHECK_THROWS_WITH(PairPotential::make("lennard-jones", "cut", {2.5, 0.0}, {{"sigma", 1.0}}),
                      Contains("unknown key 'sigma' in lennard-jones"));
}

TEST_CASE("a formula of the program is what the same formula of the library is, in every truncation") {
    for (const std::string& truncation : PairPotential::truncation_names()) {
        for (const Cutoff& cutoff : cutoffs()) {
            CAPTURE(truncation, cutoff.radius);
            const auto ours = PairPotential::lennard_jones(truncation, cutoff);
            const auto theirs = PairPotential::custom("twelve-six", test::TwelveSix{}, truncation, cutoff);
            CHECK(theirs.is_custom());
            CHECK_FALSE(ours.is_custom());
            CHECK(theirs.formula() == "twelve-six");
            CHECK(theirs.truncation() == truncation);
            CHECK(theirs.changes_from() == ours.changes_from());
            CHECK(theirs.parameters().empty());
            CHECK(theirs.expression().empty());
            for (const double r : distances(0.8, 1.1 * cutoff.radius, 500)) {
                REQUIRE(theirs(r).u == ours(r).u);
                REQUIRE(theirs(r).w == ours(r).w);
                REQUIRE(theirs.untruncated(r).u == ours.untruncated(r).u);
            }
            CHECK(theirs.tail().energy == Approx(ours.tail().energy).epsilon(1e-10));
            CHECK(theirs.tail().virial == Approx(ours.tail().virial).epsilon(1e-10));
        }
    }
}

TEST_CASE("a formula of the program has a name of its own and a known truncation") {
    const auto named = [](const std::string& name, const std::string& truncation = "cut") {
        return PairPotential::custom(name, test::TwelveSix{}, truncation, {2.5, 2.0});
    };
    CHECK_THROWS_AS(named(""), InputError);
    CHECK_THROWS_WITH(named("morse"), Contains("a name of its own") && Contains("found 'morse'"));
    CHECK_THROWS_WITH(named("mine", "smooth"), Contains("unknown truncation 'smooth'"));
    // It may be a function object without a type that anybody could name.
    const double strength = 3.0;
    const auto gaussian = PairPotential::custom("gaussian",
                                                [strength](const PairDistance<double>& d) {
                                                    const double u = strength * std::exp(-d.r2);
                                                    return PairTerm<double>{u, 2.0 * u};
                                                },
                                                "shifted", {2.5, 0.0});
    CHECK(gaussian(1.0).u == Approx(strength * (std::exp(-1.0) - std::exp(-6.25))));
    CHECK(gaussian(1.0).w == Approx(2.0 * strength * std::exp(-1.0)));
}
