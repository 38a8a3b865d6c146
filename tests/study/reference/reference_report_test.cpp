#include "study/reference/reference_report.hpp"

#include "catch.hpp"

#include "io/tables/json_text.hpp"
#include "study/reference/made_reference.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

ReferenceFindings findings() {
    ReferenceFindings found{.equilibration = 2000,
                            .pilot = {40, 12.0, 60.0},
                            .canonical = {20'000, 0.005},
                            .order = 0.01,
                            .halves = 0.5,
                            .values = {},
                            .errors = {{{"potential_energy", 0.002}, 0.001, true}}};
    ReferenceValue energy{.name = "potential_energy",
                          .symbol = "U/N",
                          .unit = "epsilon",
                          .mean = -5.0123,
                          .statistical_error = 0.0010,
                          .systematic_error = 0.0005};
    energy.by_equations = {{"thol2016", -5.01}, {"kolafa-nezbeda1994", -5.02}};
    found.values.push_back(energy);
    return found;
}

}  // namespace

TEST_CASE("the report has value, both errors and the equation of state, for programs and for people") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    const Document report = reference_report(setup, findings(), std::nullopt);
    const Data& energy = report.data.at("potential_energy");
    CHECK(energy.at("mean").number() == -5.0123);
    CHECK(energy.at("statistical_error").number() == 0.0010);
    CHECK(energy.at("systematic_error").number() == 0.0005);
    CHECK(energy.at("total_error").number() == Approx(std::hypot(0.001, 0.0005)));
    CHECK(energy.at("equation_of_state").number() == -5.01);
    CHECK(energy.at("equations_of_state").at("kolafa-nezbeda1994").number() == -5.02);
    CHECK(report.data.at("phase").text() == "liquid");
    CHECK(report.data.at("warnings").empty());
    CHECK(report.data.at("runs").at("equilibration_found").integer() == 400);
    CHECK_THAT(report.text, Contains("-5.0123(11)") && Contains("T = 1.2, rho = 0.75: liquid") && Contains("to cite:"));
    CHECK_THAT(report.data.at("citation").text(), Contains("864 atoms") && Contains("20000 steps each after 2000"));
}

TEST_CASE("a reader is warned of what makes the values worthless, or less exact than was asked") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    ReferenceFindings found = findings();
    const auto warnings = [&] { return to_json(reference_report(setup, found, 80).data.at("warnings")); };
    found.errors = {{{"potential_energy", 0.0005}, 0.001, false}};
    CHECK_THAT(warnings(), Contains("is 0.001, not 0.0005: --max-steps"));
    found.errors = {{{"potential_energy", 0.002}, 0.001, false}};
    CHECK_THAT(warnings(), Contains("does not count yet"));
    found.errors = {{{"potential_energy", 0.0004}, 0.0003, true}};
    CHECK_THAT(warnings(), Contains("the systematic error of potential_energy, 0.0005, is larger"));
    found = findings();
    found.halves = -6.0;
    CHECK_THAT(warnings(), Contains("the energy changes in the course of the runs"));
    found = findings();
    found.order = 0.4;
    CHECK_THAT(warnings(), Contains("has not melted"));
    found = findings();
    found.values.front().converged = false;
    CHECK_THAT(warnings(), Contains("is a guess"));
    found = findings();
    found.warnings = {"canonical, replica-1: something"};
    CHECK_THAT(warnings(), Contains("replica-1"));
}

TEST_CASE("what is not known is said to be so") {
    const ReferenceSetup setup = reference_setup(liquid_request());
    ReferenceFindings found = findings();
    found.values.front().mean.reset();
    found.values.front().systematic_error = std::numeric_limits<double>::quiet_NaN();
    found.values.front().remark = "the runs are too short for it";
    const Document report = reference_report(setup, found, 60);
    CHECK(report.data.at("potential_energy").at("mean").is_null());
    CHECK(report.data.at("potential_energy").at("total_error").is_null() ==
          report.data.at("potential_energy").at("systematic_error").is_null());
    CHECK_THAT(report.text, Contains("no value") && Contains("potential_energy: the runs are too short for it"));
}
