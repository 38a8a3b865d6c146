#include "ljmd/detail/options/value.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("find returns the entry of that name, to read or to change") {
    Table table{{"steps", {}, {std::int64_t{5}, {}}}, {"name", {}, {std::string("a"), {}}}};
    const Table& unchanged = table;
    REQUIRE(find(table, "name"));
    CHECK(find(unchanged, "steps") == &unchanged[0]);
    CHECK(find(unchanged, "step") == nullptr);
    CHECK(find(table, "") == nullptr);
    find(table, "steps")->value.data = 2.5;
    CHECK(std::get<double>(unchanged[0].value.data) == 2.5);
}

TEST_CASE("kind_name names each kind with its article") {
    CHECK(kind_name({true, {}}) == "a boolean");
    CHECK(kind_name({std::int64_t{1}, {}}) == "an integer");
    CHECK(kind_name({1.0, {}}) == "a float");
    CHECK(kind_name({std::string("1"), {}}) == "a string");
    CHECK(kind_name({Array{}, {}}) == "an array");
    CHECK(kind_name({Table{}, {}}) == "a table");
    CHECK(kind_name({Date{"1967-07-05"}, {}}) == "a date");
}
