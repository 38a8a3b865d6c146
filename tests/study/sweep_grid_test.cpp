#include "catch.hpp"

#include "core/text.hpp"
#include "study/sweep_points.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Values = std::vector<std::string>;

namespace {

SweepPoints points_of(const std::vector<std::string>& grids, const std::vector<std::string>& settings = {}) {
    Diagnostics diagnostics;
    SweepPoints points = grid_points(grids, settings, diagnostics);
    for (const Diagnostic& entry : diagnostics.entries()) {
        UNSCOPED_INFO(format(entry));
    }
    REQUIRE_FALSE(diagnostics.has_errors());
    return points;
}

/// The values of the only key.
Values values_of(const std::string& values) {
    Values column;
    for (const Values& row : points_of({"k=" + values}).values) {
        column.push_back(row.at(0));
    }
    return column;
}

/// The only complaint about a grid.
std::string complaint(const std::vector<std::string>& grids, const std::vector<std::string>& settings = {}) {
    Diagnostics diagnostics;
    const SweepPoints points = grid_points(grids, settings, diagnostics);
    CHECK(points.values.empty());
    REQUIRE(diagnostics.entries().size() == 1);
    return format(diagnostics.entries()[0]);
}

}  // namespace

TEST_CASE("a range has numbers at equal distances, without digits that rounding has made") {
    CHECK(values_of("0.1:0.9:9") == Values{"0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9"});
    CHECK(values_of("1.2:2.0:5") == Values{"1.2", "1.4", "1.6", "1.8", "2"});
    CHECK(values_of("-0.3:0.3:7") == Values{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"});
    CHECK(values_of("2:1:3") == Values{"2", "1.5", "1"});
    CHECK(values_of("100:400:4") == Values{"100", "200", "300", "400"});  // integers stay integers
    CHECK(values_of(" 0 : 1 : 2 ") == Values{"0", "1"});
    CHECK(values_of("-0:-1:3") == Values{"0", "-0.5", "-1"});
    CHECK(values_of("1e-20:3e-20:3") == Values{"1e-20", "2e-20", "3e-20"});
    CHECK(values_of("0:1:4")[1] == "0.33333333333333");
    CHECK(values_of("0.1234567890123456:1:2")[0] == "0.1234567890123456");  // ends are as they are given
}

TEST_CASE("a range of any size has as many numbers as it says, in order and finite") {
    for (const char* range : {"-1.7e308:1.7e308:1000", "5e-324:1e-300:10000", "0:5e-324:2", "-1e-9:1e9:10000"}) {
        INFO(range);
        const Values values = values_of(range);
        CHECK(values.size() >= 2);
        for (std::size_t k = 0; k + 1 < values.size(); ++k) {
            CHECK(to_number(values[k]).value() < to_number(values[k + 1]).value());
        }
    }
}

TEST_CASE("a list holds whatever --set takes: separators in quotes and brackets separate nothing") {
    CHECK(values_of("1|1.5 | 2") == Values{"1", "1.5", "2"});
    CHECK(values_of("86.5 K|90 K") == Values{"86.5 K", "90 K"});
    CHECK(values_of("cut") == Values{"cut"});
    CHECK(values_of("[1.0, 0.0]|[2.0, 0.0]") == Values{"[1.0, 0.0]", "[2.0, 0.0]"});
    CHECK(values_of(R"("a,b|c:d"|'x:y')") == Values{R"("a,b|c:d")", "'x:y'"});
    CHECK(values_of(R"({ type = "fcc", cells = 3 }|{ type = "fcc", cells = 4 })").size() == 2);
    CHECK(values_of("Verlet's|Rahman's") == Values{"Verlet's", "Rahman's"});
    CHECK(values_of("\xC3\x85|\xE2\x82\xAC") == Values{"\xC3\x85", "\xE2\x82\xAC"});
    CHECK(values_of("a=b|c=d") == Values{"a=b", "c=d"});
}

TEST_CASE("all combinations are points, and the last key varies fastest, in one text or in several") {
    const SweepPoints expected{{"a.x", "b", "c"},
                               {{"1", "p", "5"},
                                {"1", "p", "6"},
                                {"1", "q", "5"},
                                {"1", "q", "6"},
                                {"2", "p", "5"},
                                {"2", "p", "6"},
                                {"2", "q", "5"},
                                {"2", "q", "6"}}};
    CHECK(points_of({"a.x=1:2:2,b=p|q,c=5|6"}) == expected);
    CHECK(points_of({"a.x=1:2:2", "b=p|q , c=5|6"}) == expected);
}

TEST_CASE("a grid that is none is told of, once a mistake") {
    for (const char* grid : {"", "system.density", "k=1|2,", "b|c", ",k=1"}) {
        INFO(grid);
        CHECK_THAT(complaint({grid}), Contains("has not the form KEY=FROM:TO:COUNT or KEY=A|B|C"));
    }
    CHECK_THAT(complaint({"k="}), Contains("'k' has an empty value"));
    CHECK_THAT(complaint({"k=1||2"}), Contains("'k' has an empty value"));
    CHECK_THAT(complaint({"k=1|2|1"}), Contains("'k' has the value '1' twice"));
    CHECK_THAT(complaint({"k=1:2"}), Contains("a range has 3 parts, found 2"));
    CHECK_THAT(complaint({"k=1:2:3:4"}), Contains("a range has 3 parts, found 4"));
    CHECK_THAT(complaint({"k=1:1:3"}), Contains("FROM and TO are both 1"));
    CHECK_THAT(complaint({"k=0:-0:3"}), Contains("FROM and TO are both 0"));
    CHECK_THAT(complaint({"k=1:1.0000000000000002:5"}), Contains("the value '1' twice"));
    for (const char* from : {"nan", "inf", "-inf", "1e999", "", "86.5 K", "0x1", "\xFF", "\xE2\x82\xAC"}) {
        INFO(from);
        CHECK_THAT(complaint({"k=" + std::string(from) + ":2:3"}), Contains("FROM is ") && Contains("finite number"));
        CHECK_THAT(complaint({"k=2:" + std::string(from) + ":3"}), Contains("TO is ") && Contains("finite number"));
    }
    for (const char* count : {"1", "0", "-5", "2.5", "1e2", "", "nan", "10001", "99999999999999999999999", "+3"}) {
        INFO(count);
        CHECK_THAT(complaint({"k=1:2:" + std::string(count)}),
                   Contains("COUNT is '" + std::string(count) + "'") && Contains("from 2 to 10000"));
    }
}

TEST_CASE("keys that are none, stand twice or are given as well are told of") {
    CHECK_THAT(complaint({"=1:2:3"}), Contains("'' is no key of a deck"));
    CHECK_THAT(complaint({"a..b=1|2"}), Contains("'a..b' is no key of a deck"));
    CHECK_THAT(complaint({"system.density=1:2:3", "system . \"density\"=4|5"}), Contains("stands twice"));
    CHECK_THAT(complaint({"system.density=1:2:3"}, {"system.temperature=1", "system.density = 2"}),
               Contains("'system.density' is varied, and given by --set as well"));
}

TEST_CASE("too many points are refused before they are made") {
    CHECK(points_of({"a=1:2:100,b=1:2:100"}).values.size() == max_points);
    CHECK_THAT(complaint({"a=1:2:100,b=1:2:101"}), Contains("too many points, at most 10000 are allowed"));
    std::string huge = "k0=1:2:10000";
    for (int k = 1; k < 20; ++k) {
        huge += ",k" + std::to_string(k) + "=1:2:10000";
    }
    CHECK_THAT(complaint({huge}), Contains("too many points"));
    std::string list = "k=0";
    for (int k = 1; k <= 10'000; ++k) {
        list += "|" + std::to_string(k);
    }
    CHECK_THAT(complaint({list}), Contains("too many points"));
}

TEST_CASE("every mistake of a grid is told of at once") {
    Diagnostics diagnostics;
    static_cast<void>(grid_points({"a=1:x:0,b=|", "c"}, {}, diagnostics));
    CHECK(diagnostics.entries().size() == 4);
}
