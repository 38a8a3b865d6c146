#include "study/reproduction_report.hpp"

#include <sstream>
#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

ReproducedRow a_row() {
    const VerletRow verlet{0.85, 0.786, Printed{0.99, Soundness::sound, Provenance::one_reprint},
                           Printed{-6.05, Soundness::suspect, Provenance::one_reprint}, ""};
    return {verlet,
            10'000,
            {0.79, 0.001, 50, 100, true},
            {0.9571, 0.0138, 50, 100, true},
            {-6.05472, 0.00171, 50, 100, true},
            {0.016, 0.0065},
            {0.9986, -6.0437},
            {0.9977, -6.045}};
}

std::vector<std::string> fields(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> result;
    for (std::string field; std::getline(stream, field, ',');) {
        result.push_back(field);
    }
    return result;
}

}  // namespace

TEST_CASE("the table shows values with their errors, and marks what is suspect") {
    const std::string table = reproduction_report({a_row()}).text;
    CHECK_THAT(table, Contains("0.957(14)") && Contains("-6.0547(17)") && Contains("-6.05?") && Contains("0.999"));
    CHECK_THAT(table, Contains("chi-square of the rows that are sound: Z 3.4 of 1, U 0.0 of 0"));
    const std::string markdown = reproduction_markdown({a_row(), a_row()});
    CHECK(std::count(markdown.begin(), markdown.end(), '\n') > 4);
    CHECK_THAT(markdown, Contains("| 0.8500 | 0.786 | 0.957(14) | 0.99 | 0.999 |"));
}

TEST_CASE("on a screen the columns stand closer, then those of the cutoff are left out, and sentences are broken") {
    ReproducedRow row = a_row();
    row.verlet.remark = "a remark that is so long that it does not stand on one line of a usual terminal";
    const std::string whole = reproduction_report({row}).text;
    const auto longest = [](const std::string& text) {
        std::size_t most = 0;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            most = std::max(most, line.size());
        }
        return most;
    };
    CHECK_THAT(whole, Contains("    cutoff"));
    CHECK(longest(whole) > 100);
    CHECK_THAT(reproduction_report({row}, 200).text, StartsWith(whole.substr(0, whole.find("\n\n"))));
    const std::string close = reproduction_report({row}, 100).text;
    CHECK_THAT(close, Contains(" cutoff ") && !Contains("left out"));
    CHECK(longest(close) <= 100);
    const std::string narrow = reproduction_report({row}, 80).text;
    CHECK_THAT(narrow, Contains("\nleft out here: cutoff (rows.csv has it)\n") && Contains("0.957(14)"));
    CHECK(longest(narrow) <= 80);
}

TEST_CASE("errors have two digits, also where rounding would make it three") {
    const auto z = [](double error) {
        ReproducedRow row = a_row();
        row.z.standard_error = error;
        return reproduction_report({row}).text;
    };
    CHECK_THAT(z(0.0994), Contains("0.957(99)"));
    CHECK_THAT(z(0.0996), Contains("0.96(10)"));
    CHECK_THAT(z(0.1), Contains("0.96(10)"));
    CHECK_THAT(z(0.0), Contains("0.9571 "));
}

TEST_CASE("the CSV has a field for each column, with all digits") {
    std::istringstream csv(reproduction_csv({a_row()}));
    std::string header;
    std::string row;
    std::getline(csv, header);
    std::getline(csv, row);
    const auto names = fields(header);
    const auto values = fields(row + ",end");
    REQUIRE(values.size() == names.size() + 1);
    const auto value = [&](const std::string& name) {
        return values[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    CHECK(value("rho") == "0.85");
    CHECK(value("T") == "0.786");
    CHECK(value("T_measured") == "0.79");
    CHECK(value("Z") == "0.9571");
    CHECK(value("Z_standard_error") == "0.0138");
    CHECK(value("U") == "-6.05472");
    CHECK(value("U_standard_error") == "0.00171");
    CHECK(value("Z_verlet") == "0.99");
    CHECK(value("U_thol2016") == "-6.0437");
    CHECK(value("Z_kolafa_nezbeda1994") == "0.9977");
    CHECK(value("U_verlet_soundness") == "suspect");
    CHECK(std::stod(value("z_score_Z")) == Approx(a_row().z_scores().z));
}

TEST_CASE("the JSON has the rows and chi-square, and numbers that Verlet has not are null") {
    ReproducedRow row = a_row();
    row.verlet.potential_energy.reset();
    const Data json = reproduction_report({row}).data;
    CHECK(json["rows"][0]["Z"] == 0.9571);
    CHECK(json["rows"][0]["Z_verlet"]["value"] == 0.99);
    CHECK(json["rows"][0]["U_verlet"].is_null());
    CHECK(json["chi_square"]["Z_rows"] == 1);
}

TEST_CASE("isotherms are those of the equations of state") {
    std::istringstream csv(isotherms_csv());
    std::string line;
    std::getline(csv, line);
    CHECK(line == "T,rho,Z_thol2016,Z_kolafa_nezbeda1994");
    int rows = 0;
    for (; std::getline(csv, line); ++rows) {
        const auto values = fields(line);
        REQUIRE(values.size() == 4);
        const double z = std::stod(values[2]);
        CHECK(std::abs(z - std::stod(values[3])) < 0.2 + 0.05 * std::abs(z));
    }
    CHECK(rows > 4 * 61);  // those above the critical temperature are whole
    CHECK(rows < 6 * 61);
}

TEST_CASE("a printed number that only the printer can have made is remarked upon") {
    ReproducedRow row = a_row();
    CHECK(remark_of(row).empty());
    row.verlet.compressibility_factor->value = 1.20;
    CHECK(remark_of(row) == "Z as printed is +0.24 off, equations of state agree with what was found");
    row.thol.z = 1.20;  // who is right is open
    CHECK(remark_of(row).empty());
    row.verlet.remark = "known";
    CHECK(remark_of(row) == "known");
}
