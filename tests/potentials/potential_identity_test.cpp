#include "potentials/potential_identity.hpp"

#include "catch.hpp"

#include "potentials/twelve_six.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("potentials differ in formula, truncation, cutoff, parameters, and values of formulas of the program") {
    const auto morse = [](double well) {
        return PairPotential::make("morse", "cut", {2.5, 0.0},
                                   {{"well_depth", well}, {"steepness", 6.0}, {"minimum", 1.12}});
    };
    CHECK(identity(morse(1.0)) == identity(morse(1.0)));
    CHECK(identity(morse(1.0)) != identity(morse(1.5)));
    const std::string lennard_jones = identity(PairPotential::lennard_jones("cut", {2.5, 0.0}));
    CHECK(lennard_jones != identity(PairPotential::lennard_jones("shifted", {2.5, 0.0})));
    CHECK(lennard_jones != identity(PairPotential::lennard_jones("cut", {2.4, 0.0})));
    const auto own = [](double strength) {
        return PairPotential::custom("own",
                                     [strength](const PairDistance<double>& d) {
                                         return PairTerm<double>{strength * d.inverse_r, 0.0};
                                     },
                                     "cut", {2.5, 0.0});
    };
    CHECK(identity(own(1.0)) == identity(own(1.0)));
    CHECK(identity(own(1.0)) != identity(own(2.0)));
}
