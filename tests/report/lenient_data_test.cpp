#include "report/lenient_data.hpp"

#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("of a record without a key, or with another kind of value, nothing is found and nothing thrown") {
    const Data record = {{"a", {{"b", 2.5}, {"c", "text"}, {"d", nullptr}, {"e", true}}}, {"list", Data::list({1})}};
    CHECK(number_in(record, {"a", "b"}) == 2.5);
    CHECK(text_in(record, {"a", "b"}) == "2.5");
    CHECK(text_in(record, {"a", "c"}) == "text");
    CHECK(flag_in(record, {"a", "e"}) == true);
    CHECK_FALSE(number_in(record, {"a", "c"}));
    CHECK_FALSE(number_in(record, {"a", "d"}));
    CHECK_FALSE(flag_in(record, {"a", "b"}));
    CHECK(text_in(record, {"a", "d"}).empty());
    CHECK(text_in(record, {"list", "x"}).empty());
    CHECK(value_in(record, {"a", "b", "c"}) == nullptr);
}

TEST_CASE("a file that is no JSON is named") {
    const TemporaryFolder folder;
    overwrite(folder / "x.json", "{\"a\":");
    CHECK_THROWS_WITH(read_any_json(folder / "x.json"), Catch::Matchers::Contains("x.json"));
}
