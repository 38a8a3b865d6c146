#include "ljmd/io/data_table_csv.hpp"

#include <catch2/catch.hpp>
#include <charconv>
#include <clocale>
#include <limits>

using namespace ljmd;

namespace {
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("a table is written with its header and one line a row") {
    const DataTable table{"rdf", {"r", "g", "g_standard_error"}, {{0.5, 1.25, 0.0}, {-1.5, 1e-300, 1e22}}};
    CHECK(to_csv(table) == "r,g,g_standard_error\n0.5,1.25,0\n-1.5,1e-300,1e+22\n");
}

TEST_CASE("numbers are read back to the last bit") {
    for (const double x : {1.0 / 3.0, 0.1 + 0.2, -6.02214076e23, 5e-324, 1.7976931348623157e308, -0.0}) {
        const std::string text = to_csv({"t", {"x"}, {{x}}});
        double back = 0.0;
        const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), back);
        CHECK(error == std::errc());
        CHECK(*end == '\n');
        CHECK(back == x);
        CHECK(std::signbit(back) == std::signbit(x));
    }
}

TEST_CASE("a number that is not known is an empty field, wherever it stands") {
    CHECK(to_csv({"t", {"a", "b", "c"}, {{1.0, unknown, 3.0}, {unknown, 2.0, 3.0}, {1.0, 2.0, unknown}}}) ==
          "a,b,c\n1,,3\n,2,3\n1,2,\n");
}

TEST_CASE("a table without rows is its header") {
    CHECK(to_csv({"t", {"a", "b"}, {}}) == "a,b\n");
}

TEST_CASE("no locale reaches the numbers") {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // a decimal comma, where it is installed
    const std::string text = to_csv({"t", {"x"}, {{1234567.5}}});
    std::setlocale(LC_ALL, before.c_str());
    CHECK(text == "x\n1234567.5\n");
}
