#include "io/formats/ase_units.hpp"

#include "catch.hpp"

#include <cmath>

using namespace ljmd;

TEST_CASE("the velocity of ASE is that of an atomic mass unit with twice the kinetic energy of half an electron volt") {
    constexpr double electron_volt = 1.602176634e-19;
    constexpr double dalton = 1.66053906660e-27;
    constexpr double angstrom_per_ps = 100.0;  // in m/s
    CHECK(ase_velocity == Approx(std::sqrt(electron_volt / dalton) / angstrom_per_ps).epsilon(1e-14));
}

TEST_CASE("elements have the masses that ASE gives them, by symbols in any case") {
    CHECK(ase_mass("X") == 1.0);
    CHECK(ase_mass("Ar") == 39.948);
    CHECK(ase_mass("AR") == 39.948);
    CHECK(ase_mass("kr") == 83.798);
    CHECK(ase_mass("Og") == 294.214);
    CHECK_FALSE(ase_mass("A").has_value());
    CHECK_FALSE(ase_mass("").has_value());
    CHECK_FALSE(ase_mass("Arg").has_value());
}
