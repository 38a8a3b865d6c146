#include "study/sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

SweptPoints fluids() {
    return {
        {"system.temperature", "title"},
        {{"temperature=1.2,title=a-b",
          {"1.2", "a,b"},
          "runs/x",
          {{"temperature", 1.25, 0.0123, "a guess"}, {"potential_energy", -6.0, unknown}, {"pressure", 0.1, 0.02}},
          ""},
         {"temperature=2,title=c", {"2", "c"}, "runs/y", {}, "temperature=2,title=c: exit code 5: error: lost"},
         {"temperature=3,title=d",
          {"3", "d"},
          "runs/z",
          {{"temperature", 3.0, 0.1, "a guess"}, {"viscosity", 2.5, 0.25}, {"pressure", unknown, unknown, "one atom"}},
          ""}}};
}

}  // namespace

TEST_CASE("the table has keys and main observables in columns, and says what has failed") {
    const std::vector<std::vector<const char*>> expected{
        {"temperature", "title", "T", "U/N", "p", "Z"},
        {"1.2", "a,b", "1.250 +- 0.012 [1]", "-6", "0.100 +- 0.020", "-"},
        {"2", "c", "failed", "failed", "failed", "failed"},
        {"3", "d", "3.00 +- 0.10 [1]", "-", "- [2]", "-"},
    };
    std::string table;
    for (const auto& row : expected) {
        table += fmt::format("{:>13}{:>7}{:>23}{:>23}{:>23}{:>23}\n", row[0], row[1], row[2], row[3], row[4], row[5]);
    }
    table += "  [1] a guess\n  [2] one atom\n";
    CHECK(sweep_report(fluids()).text == table);
    CHECK(point_line(fluids().points[0]) == "T 1.250 +- 0.012, U/N -6, p 0.100 +- 0.020, Z -");
}

TEST_CASE("doubts about a run are marked behind its row, and stand in the CSV and the data") {
    SweptPoints swept = fluids();
    swept.points[2].doubts = {"the crystal has not melted", "the energy drifts"};
    const Document report = sweep_report(swept);
    CHECK_THAT(report.text,
               Catch::EndsWith("-  [3][4]\n  [1] a guess\n  [2] one atom\n  [3] the crystal has not melted\n"
                               "  [4] the energy drifts\n"));
    CHECK_THAT(sweep_csv(swept),
               Catch::EndsWith("pressure: one atom; the crystal has not melted; the energy drifts\n"));
    CHECK(report.data.at("points")[2].at("doubts").size() == 2);
    CHECK(report.data.at("points")[0].at("doubts").size() == 0);
}

TEST_CASE("numbers that are long do not run together") {
    SweptPoints swept = fluids();
    swept.points[0].found = {{"temperature", -6.626360956, 1.23e-7, "a guess"}, {"potential_energy", 1.0, 0.1}};
    CHECK_THAT(sweep_report(swept).text, Contains("a,b  -6.62636096 +- 0.00000012 [1]  "));
}

namespace {

std::size_t longest_line(const std::string& text) {
    std::size_t longest = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        longest = std::max(longest, line.size());
    }
    return longest;
}

}  // namespace

TEST_CASE("on a screen the table gets shorter errors, then fewer observables, until it fits") {
    const std::string whole = sweep_report(fluids()).text;
    CHECK(sweep_report(fluids(), 200).text == whole);
    CHECK(sweep_report(fluids(), longest_line(whole)).text == whole);
    CHECK(sweep_report(fluids(), 80).text ==
          "  temperature  title              T     U/N          p       Z\n"
          "          1.2    a,b  1.250(12) [1]      -6  0.100(20)       -\n"
          "            2      c         failed  failed     failed  failed\n"
          "            3      d   3.00(10) [1]       -      - [2]       -\n"
          "  [1] a guess\n  [2] one atom\n");
    const std::string narrow = sweep_report(fluids(), 45).text;
    CHECK_THAT(narrow, Contains("T     U/N\n") && Contains("  left out here: p, Z (sweep.csv has all)\n"));
    CHECK_THAT(narrow, !Contains("[2]"));
    for (std::size_t screen = 46; screen < 130; ++screen) {
        CHECK(longest_line(sweep_report(fluids(), screen).text) <= screen);
    }
}

TEST_CASE("a table of few bodies has their energies") {
    const SweptPoints swept{{"stage.orbits.time_step"},
                            {{"time_step=0.1", {"0.1"}, "runs/x", {{"total_energy", -0.375, unknown}}, ""}}};
    CHECK_THAT(sweep_report(swept).text, Contains("total energy\n") && Contains("-0.375\n"));
    CHECK_THAT(sweep_report(swept).text, !Contains("U/N"));
}

TEST_CASE("values that no terminal should show do not reach it") {
    SweptPoints swept = fluids();
    swept.points[0].values[1] = "\x1B[31m";
    CHECK_THAT(sweep_report(swept).text, Contains("?[31m") && !Contains("\x1B"));
}

TEST_CASE("the CSV has every observable of any point, with its error, and empty fields for the rest") {
    CHECK(
        sweep_csv(fluids()) ==
        "system.temperature,title,temperature,temperature_standard_error,potential_energy,"
        "potential_energy_standard_error,pressure,pressure_standard_error,viscosity,viscosity_standard_error,remarks\n"
        "1.2,\"a,b\",1.25,0.0123,-6,,0.1,0.02,,,temperature: a guess\n"
        "2,c,,,,,,,,,\n"
        "3,d,3,0.1,,,,,2.5,0.25,temperature: a guess; pressure: one atom\n");
    CHECK(sweep_csv({{"a"}, {}}) == "a,remarks\n");
}

TEST_CASE("the JSON has values as what they are, and null for what is not known") {
    SweptPoints swept = fluids();
    swept.points[0].values = {"1.2", "[1.0, 0.5]"};
    const auto json = sweep_report(swept).data;
    CHECK(json["keys"] == std::vector<std::string>{"system.temperature", "title"});
    const auto& first = json["points"][0];
    CHECK(first["values"]["system.temperature"] == 1.2);
    CHECK(first["values"]["title"] == std::vector<double>{1.0, 0.5});
    CHECK(first["directory"] == "runs/x");
    CHECK(first["failure"].is_null());
    CHECK(first["observables"]["temperature"]["mean"] == 1.25);
    CHECK(first["observables"]["temperature"]["remark"] == "a guess");
    CHECK_FALSE(first["observables"]["pressure"].contains("remark"));
    CHECK(first["observables"]["potential_energy"]["standard_error"].is_null());
    CHECK(json["points"][1]["failure"] == "temperature=2,title=c: exit code 5: error: lost");
    CHECK(json["points"][1]["values"]["title"] == "c");
}

TEST_CASE("a value that is nested too deeply for JSON is a text") {
    SweptPoints swept = fluids();
    swept.points[0].values[1] = std::string(100'000, '[') + std::string(100'000, ']');
    CHECK(sweep_report(swept).data.at("points").at(0).at("values").at("title") == swept.points[0].values[1]);
}

TEST_CASE("a name with a comma is one field of the CSV") {
    const SweptPoints swept{{"a"}, {{"a=1", {"1"}, "x", {{"orbit_b,c", 1.0, 0.5}}, ""}}};
    CHECK(sweep_csv(swept) == "a,\"orbit_b,c\",\"orbit_b,c_standard_error\",remarks\n1,1,0.5,\n");
}
