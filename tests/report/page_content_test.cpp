#include "report/page_content.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("numbers of tables have nine digits, what is not finite is null") {
    PageTable table{.name = "t", .title = "T", .file = "t.csv", .rows = 10};
    table.add({"x"}, std::vector<double>{1.0 / 3.0, std::nan("")});
    table.add({"x_standard_error"}, std::vector<double>{0.1, 0.2});
    table.add({"name"}, std::vector<std::string>{"a", "b"});
    const Data data =
        page_data({.kind = "run", .title = "", .source = "", .tables = {table}}).at("tables").at(std::size_t{0});
    CHECK(data["values"][0][0] == 0.333333333);
    CHECK(data["values"][0][1].is_null());
    CHECK(data["rows"] == 10);
    CHECK(data["shown"] == 2);
    CHECK(data["columns"][1]["error_of"] == "x");
    CHECK_FALSE(data["columns"][0].contains("error_of"));
    CHECK(data["columns"][2]["label"] == "name");
}

TEST_CASE("a table says whether it is open from the start, and which column marks rows") {
    const PageTable plain{.name = "plain", .title = ""};
    const PageTable leading{.name = "leading", .title = "", .lead = true, .flag = "suspect"};
    const Data tables = page_data({.kind = "run", .title = "", .source = "", .tables = {plain, leading}}).at("tables");
    CHECK_FALSE(tables[0].contains("lead"));
    CHECK_FALSE(tables[0].contains("flag"));
    CHECK(tables[1]["lead"] == true);
    CHECK(tables[1]["flag"] == "suspect");
}

TEST_CASE("remarks on quantities become footnotes, equal ones a single one") {
    const std::vector<Quantity> quantities{{.name = "a", .value = 1.0, .error = 0.01, .remark = "short"},
                                           {.name = "b", .value = 2.0, .remark = "short"},
                                           {.name = "c", .value = std::nan(""), .remark = "none"},
                                           {.name = "d",
                                            .value = 3.0,
                                            .value_in_si = 4.0,
                                            .error_in_si = 0.1,
                                            .si_unit = "K",
                                            .reference = 3.5,
                                            .reference_label = "theory"}};
    const Data data = page_data({.kind = "run", .title = "", .source = "", .quantities = quantities});
    CHECK(data["footnotes"] == Data::list({"[1] short", "[2] none"}));
    CHECK(data["quantities"][0]["text"] == "1.000 +- 0.010");
    CHECK(data["quantities"][1]["mark"] == "[1]");
    CHECK(data["quantities"][2]["text"] == "no value");
    CHECK(data["quantities"][2]["value"].is_null());
    CHECK(data["quantities"][3]["si_text"] == "4.00 +- 0.10");
    CHECK(data["quantities"][3]["reference"]["label"] == "theory");
    CHECK_FALSE(data["quantities"][3].contains("mark"));
}

TEST_CASE("a part that cannot be read leaves a warning, a mistake of ljmd does not pass as one") {
    std::vector<std::string> warnings;
    add_if_readable(warnings, [] { throw DataError("x.csv is damaged"); });
    CHECK(warnings == std::vector<std::string>{"x.csv is damaged"});
    CHECK_THROWS_AS(add_if_readable(warnings, [] { throw ContractViolation("bug"); }), ContractViolation);
}

TEST_CASE("parts that a page lacks are not in its data, members are whole pages") {
    const Data plain = page_data({.kind = "run", .title = "t", .source = "s"});
    for (const char* key : {"atoms", "tracks", "points", "members"}) {
        CHECK_FALSE(plain.contains(key));
    }
    PageContent set{.kind = "set", .title = "", .source = ""};
    set.members.emplace_back("A", PageContent{.kind = "run", .title = "t", .source = "s"});
    CHECK(page_data(set).at("members").at(std::size_t{0}).at("payload") == plain);
}
