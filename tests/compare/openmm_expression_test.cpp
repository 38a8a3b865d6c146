#include "compare/openmm_expression.hpp"

#include "catch.hpp"

#include "forces/every_potential.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

// What the expressions are worth is tested against OpenMM itself, for every potential: tests/parity/openmm_test.cpp.

TEST_CASE("every formula with every truncation has an expression that ends in a scaled distance") {
    for (const PairPotential& potential : every_potential()) {
        const std::string text = openmm_expression(potential);
        INFO(text);
        CHECK(text.ends_with("; r=scale*r"));
        CHECK(text.find("u=" + potential.expression()) != std::string::npos);
    }
}

TEST_CASE("the expression of Lennard-Jones, force-shifted, reads as it is defined") {
    CHECK(openmm_expression(PairPotential::lennard_jones("force-shifted", {2.5, 0.0})) ==
          "u-u_cutoff+(r-cutoff)*f_cutoff; u=4*(r^-12-r^-6); r=scale*r");
    CHECK(openmm_formula(PairPotential::lennard_jones("force-shifted", {2.5, 0.0})) == "4*(r^-12-r^-6); r=scale*r");
}

TEST_CASE("every parameter of a formula stands in its expression") {
    for (const PairPotential& potential : every_potential()) {
        for (const auto& [name, value] : potential.parameters()) {
            INFO(name << " in " << potential.expression());
            CHECK(potential.expression().find(name) != std::string::npos);
        }
    }
}
