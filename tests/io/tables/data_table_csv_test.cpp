#include "io/tables/data_table_csv.hpp"

#include <fmt/format.h>

#include <charconv>
#include <clocale>
#include <cmath>
#include <limits>
#include "catch.hpp"

#include "io/files/text_file.hpp"
#include "io/written_file.hpp"

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
    constexpr double infinite = std::numeric_limits<double>::infinity();
    CHECK(to_csv({"t", {"a", "b"}, {{infinite, 1.0}, {1.0, -infinite}}}) == "a,b\n,1\n1,\n");
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

TEST_CASE("a table is read back as it was written, unknown numbers too") {
    const DataTable table{
        "t", {"a", "b", "c"}, {{1.0 / 3.0, unknown, 3.0}, {unknown, 2e-300, -0.0}, {1.0, 2.0, unknown}}};
    const test::WrittenFile file(to_csv(table), "t.csv");
    const DataTable back = read_csv(file.path());
    CHECK(back.name == "t");
    CHECK(back.columns == table.columns);
    CHECK(to_csv(back) == to_csv(table));
    CHECK(column(back, "a")[0] == 1.0 / 3.0);
    CHECK(column(back, "c")[0] == 3.0);
    CHECK(std::isnan(column(back, "b")[0]));
    CHECK_THROWS_WITH(column(back, "d"), "t.csv has no column 'd'");
}

TEST_CASE("headers and blanks of other programs are read") {
    for (const char* text : {"# step, u\n 0, -1.5\n5 ,2\t\n", "\"step\",'u'\n0,-1.5\n5,2\n"}) {
        const test::WrittenFile file(text, "t.csv");
        CHECK(csv_columns(file.path()) == std::vector<std::string>{"step", "u"});
        const DataTable table = read_csv(file.path());
        CHECK(step_column(table, file.path()) == std::vector<Index>{0, 5});
        CHECK(column(table, "u") == std::vector<double>{-1.5, 2.0});
    }
}

TEST_CASE("a table is read up to a number that is not finite, if rows come before") {
    const test::WrittenFile file("a,b\n1,2\n3,nan\n4,5\n", "t.csv");
    std::string loss;
    CHECK(read_finite_csv(file.path(), loss).rows == std::vector<std::vector<double>>{{1.0, 2.0}});
    CHECK_THAT(loss, Catch::Matchers::Contains("t.csv:3: b must be a finite number, found 'nan'"));
    CHECK_THROWS_AS(read_csv(file.path()), DataError);
    const test::WrittenFile first("a\ninf\n2\n", "t.csv");
    CHECK_THROWS_AS(read_finite_csv(first.path(), loss), NotFinite);
}

TEST_CASE("a table with one column, and one without rows, are read") {
    const test::WrittenFile one("x\n1\n\n3\n", "one.csv");
    CHECK(read_csv(one.path()).rows.size() == 3);  // the empty line is a row whose number is not known
    const test::WrittenFile none("a,b\n", "none.csv");
    CHECK(read_csv(none.path()).rows.empty());
}

TEST_CASE("what is no table is refused with the line") {
    const auto refused = [](const std::string& text) {
        const test::WrittenFile file(text, "t.csv");
        try {
            static_cast<void>(read_csv(file.path()));
        } catch (const DataError& error) {
            return std::string(error.what()).substr(file.path().string().size());
        }
        return std::string("nothing");
    };
    CHECK(refused("") == ": no header: the file is empty");
    CHECK(refused("a,b\n1\n") == ":2: 1 fields, but 2 columns");
    CHECK(refused("a,b\n1,2\n1,2,3\n") == ":3: 3 fields, but 2 columns");
    CHECK(refused("a,b\n1,x\n") == ":2: b must be a finite number, found 'x'");
}

TEST_CASE("of a table that is still written the last line counts when it has its end") {
    const auto rows = [](const std::string& text) {
        const test::WrittenFile file(text, "t.csv");
        return read_growing_csv(file.path()).rows.size();
    };
    CHECK(rows("a,b\n1,2\n3,4\n") == 2);
    CHECK(rows("a,b\n1,2\n3,4") == 1);
    CHECK(rows("a,b\n1,2\n3,") == 1);
    CHECK(rows("a,b\n1,2\n3") == 1);
    CHECK(rows("a,b") == 0);
    const test::WrittenFile damaged("a,b\n1\n3,4", "t.csv");
    CHECK_THROWS_AS(read_growing_csv(damaged.path()), DataError);
}

TEST_CASE("the steps of a history are whole numbers that grow") {
    const auto steps = [](const std::string& text) {
        const test::WrittenFile file("time,step\n" + text, "h.csv");
        return step_column(read_csv(file.path()), "h.csv");
    };
    CHECK(steps("0,0\n1,5\n2,9007199254740992\n") == std::vector<Index>{0, 5, 9007199254740992});
    CHECK(steps("").empty());
    CHECK_THROWS_WITH(steps("0,0\n1,\n"), "h.csv:3: 'step' is empty");
    for (const char* wrong : {"-1", "0.5", "1e300", "9007199254740994", "0"}) {
        CHECK_THROWS_WITH(steps(fmt::format("0,0\n1,{}\n", wrong)), Catch::Contains("h.csv:3: 'step' is "));
    }
    for (const char* no_number : {"nan", "inf", "-nan"}) {
        CHECK_THROWS_AS(steps(fmt::format("0,{}\n", no_number)), DataError);
    }
    CHECK_THROWS_WITH(step_column({"h", {"time"}, {}}, "h.csv"), "h.csv has no column 'step'");
}
