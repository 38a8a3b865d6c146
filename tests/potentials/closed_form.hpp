#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>
#include "catch.hpp"

#include "potentials/made_potential.hpp"

/// Pair energies and w in closed form, in long double, written a second time: what formulas and truncations are held
/// against.
namespace ljmd::test {

using Real = long double;

/// A value and the sum of the absolute values of the terms that it was added up from: what its round-off is measured
/// by.
struct Sum {
    Real value = 0.0L;
    Real terms = 0.0L;
};
inline Sum term(Real value) {
    return {value, std::abs(value)};
}
inline Sum operator+(const Sum& a, const Sum& b) {
    return {a.value + b.value, a.terms + b.terms};
}
inline Sum operator-(const Sum& a, const Sum& b) {
    return {a.value - b.value, a.terms + b.terms};
}
inline Sum operator*(const Sum& a, const Sum& b) {
    return {a.value * b.value, a.terms * b.terms};
}
inline Sum operator/(const Sum& a, const Sum& b) {
    return {a.value / b.value, a.terms / std::abs(b.value)};
}

/// A formula in closed form: energy and its derivative u'(r).
struct ClosedForm {
    std::function<Sum(Real)> u;
    std::function<Sum(Real)> slope;
};

/// f(x), where x is itself a sum: the rounding of x, three operations at half an eps, counts as much as the slope of f
/// makes of it. Without this the gate is wrong where an argument, a (r - r0) or (r - rs)/(rc - rs), magnifies the
/// rounding of r: 11.7 eps were measured for Morse at r = 4, and 60 eps for the switch over a width of 0.1; with it 2
/// eps.
inline Sum function_of(const Sum& x, const Sum& f, Real slope) {
    constexpr Real share = 1.5L / 5.0L;
    return {f.value, f.terms + share * std::abs(slope) * x.terms};
}

/// u and w = -u'/r of a truncated formula.
struct Expected {
    Sum u, w;
};

inline Expected truncated(const ClosedForm& formula, const std::string& truncation, const Cutoff& cutoff, Real r) {
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

/// Cutoffs near and far, with narrow and wide switches.
inline std::vector<Cutoff> cutoffs() {
    return {{2.5, 2.0}, {3.0, 2.9}, {std::pow(2.0, 1.0 / 6.0), 0.9}, {4.0, 0.85}};
}

/// Distances in [low, high), both ends among them.
inline std::vector<double> distances(double low, double high, int count) {
    std::mt19937_64 generator(41);
    std::uniform_real_distribution<double> uniform(low, high);
    std::vector<double> all = {low, std::nextafter(high, 0.0)};
    for (int k = 0; k < count; ++k) {
        all.push_back(uniform(generator));
    }
    return all;
}

/// Checks that u and w of a formula, with every truncation and cutoff, are those of its closed form to 5 eps times the
/// sum of the absolute values of its terms.
/// @param numbers  parameters of the formula; others take the values of made_potential()
inline void check_closed_form(const std::string& formula, const std::map<std::string, double>& numbers,
                              const ClosedForm& closed_form) {
    constexpr Real gate = 5.0L * std::numeric_limits<double>::epsilon();
    for (const std::string& truncation : PairPotential::truncation_names()) {
        for (const Cutoff& cutoff : cutoffs()) {
            const auto potential = made_potential(formula, truncation, cutoff, numbers);
            Real worst_u = 0.0L;
            Real worst_w = 0.0L;
            for (const double r : distances(0.8, cutoff.radius, 5000)) {
                const double r2 = r * r;
                const auto found = potential.visit([r2](const auto& pair) { return pair_term(pair, r2); });
                const Expected expected = truncated(closed_form, truncation, cutoff, std::sqrt(static_cast<Real>(r2)));
                worst_u = std::max(worst_u, std::abs(found.u - expected.u.value) / expected.u.terms);
                worst_w = std::max(worst_w, std::abs(found.w - expected.w.value) / expected.w.terms);
            }
            CAPTURE(formula, truncation, cutoff.radius, worst_u / gate, worst_w / gate);
            CHECK(worst_u < gate);
            CHECK(worst_w < gate);
        }
    }
}

}  // namespace ljmd::test
