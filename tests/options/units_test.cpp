#include "ljmd/detail/options/units.hpp"

#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

Approx near(double value) {
    return Approx(value).epsilon(1e-14).margin(0.0);
}

}  // namespace

TEST_CASE("parse_quantity knows every unit of the deck") {
    struct Case {
        const char* text;
        Dimension dimension;
        double si;
    };
    const Case cases[] = {
        {"3.405 angstrom", Dimension::length, 3.405e-10},
        {"3.405 A", Dimension::length, 3.405e-10},
        {"3.405 \xC3\x85", Dimension::length, 3.405e-10},
        {"3.405 \xE2\x84\xAB", Dimension::length, 3.405e-10},
        {"0.3405nm", Dimension::length, 3.405e-10},
        {" 340.5  pm ", Dimension::length, 3.405e-10},
        {"3.405e-10 m", Dimension::length, 3.405e-10},
        {"119.8 K", Dimension::energy, 119.8 * 1.380649e-23},
        {"1 kJ/mol", Dimension::energy, 1000.0 / 6.02214076e23},
        {"1 kcal/mol", Dimension::energy, 4184.0 / 6.02214076e23},
        {"2 eV", Dimension::energy, 2.0 * 1.602176634e-19},
        {"2eV", Dimension::energy, 2.0 * 1.602176634e-19},
        {"1e-21 J", Dimension::energy, 1e-21},
        {"+86.5 K", Dimension::temperature, 86.5},
        {"-86.5 K", Dimension::temperature, -86.5},
        {"39.948 u", Dimension::mass, 39.948 * 1.66053906660e-27},
        {"39.948 amu", Dimension::mass, 39.948 * 1.66053906660e-27},
        {"39.948 Da", Dimension::mass, 39.948 * 1.66053906660e-27},
        {"39.948 g/mol", Dimension::mass, 0.039948 / 6.02214076e23},
        {"1 kg", Dimension::mass, 1.0},
        {"1 ns", Dimension::time, 1e-9},
        {"1 ps", Dimension::time, 1e-12},
        {"1 fs", Dimension::time, 1e-15},
        {"1 s", Dimension::time, 1.0},
        {"1374 kg/m3", Dimension::density, 1374.0},
        {"1.374 g/cm3", Dimension::density, 1374.0},
        {"1 Pa", Dimension::pressure, 1.0},
        {"1 kPa", Dimension::pressure, 1e3},
        {"1 MPa", Dimension::pressure, 1e6},
        {"1 bar", Dimension::pressure, 1e5},
        {"1 atm", Dimension::pressure, 101325.0},
        {"1 m/s", Dimension::velocity, 1.0},
        {"1 nm/ps", Dimension::velocity, 1e3},
        {"1 angstrom/ps", Dimension::velocity, 1e2},
    };
    for (const Case& c : cases) {
        INFO(c.text);
        const auto value = parse_quantity(c.text, c.dimension);
        REQUIRE(value);
        CHECK(*value == near(c.si));
    }
}

TEST_CASE("parse_quantity refuses what is no number with a unit of the dimension") {
    for (const char* text : {"", " ", "K", "86.5", "86.5 k", "86.5 K K", "eighty K", "nan K", "inf K", "1e400 K",
                             "+-5 K", "++5 K", "0x10 K", "86,5 K", "86.5 angstrom"}) {
        INFO(text);
        CHECK_FALSE(parse_quantity(text, Dimension::temperature));
    }
    CHECK_FALSE(parse_quantity("1e308 GPa", Dimension::pressure));
    CHECK_FALSE(parse_quantity("1e308 MPa", Dimension::pressure));
    CHECK_FALSE(parse_quantity("1", Dimension::none));
}

TEST_CASE("unit_of separates the unit, known or not") {
    CHECK(unit_of("86.5 K") == std::string("K"));
    CHECK(unit_of(" 1e3parsec ") == std::string("parsec"));
    CHECK(unit_of("0.8") == std::string());
    CHECK_FALSE(unit_of("hot"));
    CHECK_FALSE(unit_of("nan K"));
}

TEST_CASE("messages name dimensions and their units") {
    CHECK(unit_names(Dimension::length) == "angstrom, nm, pm or m");
    CHECK(unit_names(Dimension::temperature) == "K");
    CHECK(unit_names(Dimension::density) == "g/cm3 or kg/m3");
    CHECK(unit_names(Dimension::none).empty());
    CHECK(dimension_name(Dimension::none) == "no dimension");
    const Dimension all[] = {Dimension::length, Dimension::energy,  Dimension::temperature, Dimension::mass,
                             Dimension::time,   Dimension::density, Dimension::pressure,    Dimension::velocity};
    const std::string names[] = {"length", "energy", "temperature", "mass", "time", "density", "pressure", "velocity"};
    for (std::size_t i = 0; i < 8; ++i) CHECK(dimension_name(all[i]) == names[i]);
}

TEST_CASE("the units of argon are the ones of the literature") {
    const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
    CHECK(argon.kelvin() == near(119.8));
    CHECK(argon.nanometre() == near(0.3405));
    CHECK(argon.dalton() == near(39.948));
    CHECK(argon.picosecond() == Approx(2.15635).epsilon(1e-5));  // tau of Rahman (1964) is 2.16 ps
    CHECK(argon.kilojoule_per_mole() == Approx(0.996072).epsilon(1e-6));
    CHECK(argon.gram_per_cm3() == Approx(1.680323).epsilon(1e-6));
    CHECK(argon.bar() == Approx(418.9756).epsilon(1e-6));
    CHECK(argon.si(Dimension::none) == 1.0);
    // Velocity is length over time, pressure energy over volume, and there and back is the same.
    CHECK(argon.si(Dimension::velocity) == near(argon.si(Dimension::length) / argon.si(Dimension::time)));
    CHECK(argon.si(Dimension::energy) ==
          near(argon.si(Dimension::mass) * argon.si(Dimension::velocity) * argon.si(Dimension::velocity)));
    CHECK(argon.reduced(2.0 * argon.si(Dimension::time), Dimension::time) == near(2.0));
}

TEST_CASE("the units of a substance are finite and positive") {
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, inf, nan}) {
        CHECK_THROWS_AS(SubstanceUnits(bad, 1.0, 1.0), InputError);
        CHECK_THROWS_AS(SubstanceUnits(1.0, bad, 1.0), InputError);
        CHECK_THROWS_AS(SubstanceUnits(1.0, 1.0, bad), InputError);
    }
}

TEST_CASE("a wall time is a number above zero with a unit of time") {
    CHECK(parse_wall_time("90 s") == 90.0);
    CHECK(parse_wall_time("90s") == 90.0);
    CHECK(parse_wall_time("0.5 min") == 30.0);
    CHECK(parse_wall_time("2h") == 7200.0);
    CHECK(parse_wall_time("1 d") == 86400.0);
    for (const char* wrong :
         {"", "5", "s", "0 s", "-1 s", "nan s", "inf h", "1e9 d", "2 hours", "1 h 30 min", "2 ns"}) {
        INFO(wrong);
        CHECK_FALSE(parse_wall_time(wrong));
    }
}
