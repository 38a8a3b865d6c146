#include "io/formats/h5md_units.hpp"

#include "catch.hpp"

#include "io/hdf5/hdf5_output.hpp"
#include "io/output_fixtures.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const H5mdQuantities all{"r", "t", "v", "box"};

SubstanceUnits argon() {
    return {3.405e-10, 1.654e-21, 6.6335e-26};
}

/// The scale of a file whose four datasets have these units; an empty one: none.
H5mdScale scale(const std::vector<std::string>& file_units, const std::optional<SubstanceUnits>& units = argon(),
                const H5mdQuantities& quantities = all) {
    const TemporaryFolder folder;
    Hdf5Output output(folder / "a.h5");
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string name = std::vector<std::string>{"r", "t", "v", "box"}[k];
        output.write_numbers(name, std::vector<double>{1.0});
        if (!file_units[k].empty()) {
            output.set_variable_text(name, "unit", file_units[k]);
        }
    }
    output.close();
    return h5md_scale(Hdf5Input(folder / "a.h5"), quantities, units);
}

std::string complaint(const std::vector<std::string>& file_units,
                      const std::optional<SubstanceUnits>& units = argon()) {
    return data_error([&] { static_cast<void>(scale(file_units, units)); });
}

}  // namespace

TEST_CASE("a file without units is in reduced ones, with a substance or without") {
    for (const auto& units : {std::optional<SubstanceUnits>(), std::optional(argon())}) {
        const H5mdScale found = scale({"", "", "", ""}, units);
        CHECK((found.length == 1.0 && found.time == 1.0 && found.velocity == 1.0 && found.edges == 1.0));
    }
}

TEST_CASE("units of H5MD files, in their spellings") {
    const double sigma = argon().si(Dimension::length);
    const double tau = argon().si(Dimension::time);
    const H5mdScale nm = scale({"nm", "ps", "nm ps-1", "nm"});
    CHECK(nm.length == Approx(sigma / 1e-9));
    CHECK(nm.time == Approx(tau / 1e-12));
    CHECK(nm.velocity == Approx(sigma / tau / 1e3));
    CHECK(nm.edges == nm.length);
    const H5mdScale angstrom = scale({"Angstrom", "fs", "Angstrom fs-1", "nm"});
    CHECK(angstrom.length == Approx(sigma / 1e-10));
    CHECK(angstrom.time == Approx(tau / 1e-15));
    CHECK(angstrom.velocity == Approx(sigma / tau / 1e5));
    CHECK(angstrom.edges == Approx(sigma / 1e-9));
    CHECK(scale({"A", "ns", "A/ns", ""}).velocity == Approx(sigma / tau / 1e-1));
    CHECK(scale({"A", "ns", "A/ns", ""}).edges == Approx(sigma / 1e-10));
}

TEST_CASE("what is not there needs no unit") {
    CHECK_NOTHROW(scale({"nm", "ps", "", ""}, argon(), {"r", "t", "", "box"}));
    CHECK_NOTHROW(scale({"nm", "", "", ""}, argon(), {"r", "none", "", "box"}));
}

TEST_CASE("units that cannot be used are refused") {
    CHECK_THAT(complaint({"nm", "ps", "nm ps-1", ""}, std::nullopt), Contains("a deck with [argon] is needed"));
    CHECK_THAT(complaint({"furlong", "ps", "nm ps-1", ""}),
               Contains("r is in 'furlong', which is no known unit of length"));
    CHECK_THAT(complaint({"nm", "ps", "nm ps", ""}), Contains("no known unit of velocity"));
    CHECK_THAT(complaint({"nm", "ps", "nm", ""}), Contains("no known unit of velocity"));
    CHECK_THAT(complaint({"nm", "", "nm ps-1", ""}), Contains("positions have a unit, but t has none"));
    CHECK_THAT(complaint({"", "ps", "", ""}), Contains("positions have no unit, but t has one"));
    CHECK_THAT(complaint({"", "", "", "nm"}), Contains("positions have no unit, but box has one"));
    CHECK_THAT(complaint({"nm", "ps", "nm ps-1", "acre"}), Contains("box is in 'acre'"));
}
