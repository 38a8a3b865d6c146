#include "core/text_table.hpp"

#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Align = TextTable::Align;

TEST_CASE("a column is as wide as its longest entry and never touches the next one") {
    TextTable table({{"steps"}, {"U/N", Align::right, 12}, {"unit", Align::left}});
    table.add({"2000", "-6.626360956 +- 0.000000012", "epsilon"});
    table.add({"20", "1", "epsilon tau/sigma^3"});
    CHECK(table.text() ==
          "steps                          U/N  unit\n"
          " 2000  -6.626360956 +- 0.000000012  epsilon\n"
          "   20                            1  epsilon tau/sigma^3\n");
}

TEST_CASE("short entries get the width that was asked for") {
    TextTable table({{"name", Align::left, 8}, {"T", Align::right, 6}}, 2);
    table.add({"a", "1.5"});
    table.add({"zero", "-0.0"});
    CHECK(table.text() ==
          "  name           T\n"
          "  a            1.5\n"
          "  zero         0.0\n");
}

TEST_CASE("a table without headings begins with its rows, and missing entries leave no blanks at the end of a line") {
    TextTable table({{""}, {"", Align::left}, {""}});
    table.add({"1", "one"});
    table.add({"10", "", "x"});
    CHECK(table.text() ==
          " 1  one\n"
          "10       x\n");
    CHECK(TextTable({{""}}).text().empty());
}

TEST_CASE("a column of nothing takes no room") {
    TextTable table({{"a"}, {""}, {"b"}});
    table.add({"1", "", "2"});
    CHECK(table.text() ==
          "a  b\n"
          "1  2\n");
}

TEST_CASE("widths count characters, and what a terminal would obey is a question mark") {
    TextTable table({{"", Align::left}, {"", Align::left}});
    table.add({"\xC3\xA9t\xC3\xA9", "|"});
    table.add({"a\x1B[1m", "|"});
    CHECK(table.text() ==
          "\xC3\xA9t\xC3\xA9    |\n"
          "a?[1m  |\n");
}

TEST_CASE("a table that is too wide narrows its first column, whose long entries then stand above their rows") {
    TextTable table({{"observable", Align::left}, {"mean"}, {"", Align::left, 0, 1}, {"unit", Align::left}}, 2);
    table.add({"pressure", "1.5", "[1]", "bar"});
    table.add({"compressibility_factor", "0.25", "", "1"});
    CHECK(table.text_within(80) == table.text());
    CHECK(table.text_within(40) == table.text());
    CHECK(table.text_within(39) ==
          "  observable             mean      unit\n"
          "  pressure                1.5 [1]  bar\n"
          "  compressibility_factor\n"
          "                         0.25      1\n");
    CHECK(table.text_within(5) ==  // no narrower than it can be
          "  observable\n"
          "        mean      unit\n"
          "  pressure\n"
          "         1.5 [1]  bar\n"
          "  compressibility_factor\n"
          "        0.25      1\n");
}

TEST_CASE("a mean and its error stand in two columns, and no error above 0 is shown as 0") {
    using Pair = std::pair<std::string, std::string>;
    CHECK(mean_and_error(-6.08712, 0.00123) == Pair("-6.0871", "0.0012"));
    CHECK(mean_and_error(-2.5413951, 1.1e-9) == Pair("-2.5413951000", "0.0000000011"));
    CHECK(mean_and_error(-2.5413951, 1.1e-15) == Pair("-2.5413951", "1.1e-15"));
    CHECK(mean_and_error(1.5, 0.0) == Pair("1.5", "0"));
    CHECK(mean_and_error(1.5, std::numeric_limits<double>::quiet_NaN()) == Pair("1.5", "-"));
}

TEST_CASE("a row has no more entries than there are columns") {
    TextTable table({{"one"}});
    CHECK_THROWS_AS(table.add({"1", "2"}), ContractViolation);
}
