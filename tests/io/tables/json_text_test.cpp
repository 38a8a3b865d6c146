#include "io/tables/json_text.hpp"

#include "io/tables/exact_json.hpp"

#include <fmt/format.h>

#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("values are written with two spaces a level, members in their order") {
    const Data data = {
        {"b", 1},
        {"a", {{"list", Data::list({1.5, "x", Data::list(), {{"k", nullptr}}})}, {"empty", Data::object()}}},
        {"last", true}};
    const std::string expected = R"({
  "b": 1,
  "a": {
    "list": [
      1.5,
      "x",
      [],
      {
        "k": null
      }
    ],
    "empty": {}
  },
  "last": true
})";
    CHECK(to_json(data) == expected);
    CHECK(to_json(parse_json(expected)) == expected);
    CHECK(to_json_line(data) == R"({"b":1,"a":{"list":[1.5,"x",[],{"k":null}],"empty":{}},"last":true})");
}

TEST_CASE("numbers are read back as the same doubles and integers") {
    const std::vector<std::pair<Data, std::string>> cases{
        {0.0, "0.0"},
        {0.1, "0.1"},
        {2.0, "2.0"},
        {1e-7, "1e-07"},
        {1e15, "1e+15"},
        {123456789.0, "123456789.0"},
        {1e22, "1e+22"},
        {1.0 / 3.0, "0.3333333333333333"},
        {5e-324, "5e-324"},
        {std::numeric_limits<double>::max(), "1.7976931348623157e+308"},
        {std::numeric_limits<double>::infinity(), "null"},
        {std::numeric_limits<std::int64_t>::min(), "-9223372036854775808"},
        {std::numeric_limits<std::int64_t>::max(), "9223372036854775807"},
        {std::numeric_limits<std::uint64_t>::max(), "18446744073709551615"}};
    for (const auto& [value, text] : cases) {
        CHECK(to_json(value) == text);
        CHECK(parse_json(text) == value);
    }
    CHECK(to_json(Data::list({-0.0, 1.0})) == to_json(Data::list({0.0, 1.0})));
    CHECK(to_json_line({{"a", -0.0}}) == R"({"a":0.0})");
    CHECK(to_exact_json(-0.0) == "-0.0");
}

TEST_CASE("texts are written with escapes, and bytes that are not UTF-8 as U+FFFD") {
    CHECK(to_json("a\"\\\n\t\x01") == R"("a\"\\\n\t\u0001")");
    CHECK(to_json("\xC3\xA9") == "\"\xC3\xA9\"");
    CHECK(to_json_line("\xC3\xA9") == R"("\u00e9")");
    CHECK(to_json("d\xFF.toml") == "\"d\xEF\xBF\xBD.toml\"");
    CHECK(to_json({{"d\xFF", 1}}) == "{\n  \"d\xEF\xBF\xBD\": 1\n}");
    CHECK(parse_json(R"("\u00e9\ud83d\ude00")").text() == "\xC3\xA9\xF0\x9F\x98\x80");
}

TEST_CASE("objects keep their order when they are read, and the last of members with one name counts") {
    const Data data = parse_json(R"({"b": 1, "a": 2, "b": {"c": []}})");
    REQUIRE(data.size() == 2);
    CHECK(data.members().front().key == "b");
    CHECK(data.at("b").at("c").empty());
}

TEST_CASE("what is no JSON is refused in the words of the library, without its numbers") {
    for (const char* text : {"", "{", "[1,]", "nul", "[1] x", "\"\xFF\""}) {
        INFO(text);
        CHECK_THROWS_WITH(parse_json(text), Catch::StartsWith("parse error at line 1"));
    }
    CHECK_THROWS_WITH(parse_json("1e999"), Catch::StartsWith("number overflow"));
}

TEST_CASE("depth, values and keys of JSON have bounds, before anything takes much stack, memory or time") {
    const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
    CHECK(parse_json(nested(deepest_json)).is_list());
    CHECK_THROWS_WITH(parse_json(nested(deepest_json + 1)), "it is nested deeper than 32 levels");
    CHECK_THROWS_WITH(parse_json(nested(1'000'000)), "it is nested deeper than 32 levels");
    std::string objects;
    for (int k = 0; k < 100'000; ++k) {
        objects += R"({"n":)";
    }
    CHECK_THROWS_WITH(parse_json(objects), "it is nested deeper than 32 levels");

    const auto keys = [](std::size_t count) {
        std::string text = "{";
        for (std::size_t k = 0; k < count; ++k) {
            text += fmt::format("{}\"k{}\": 1", k == 0 ? "" : ", ", k);
        }
        return text + "}";
    };
    CHECK(parse_json("[" + keys(max_json_keys) + ", " + keys(max_json_keys) + "]").size() == 2);
    CHECK_THROWS_WITH(parse_json(keys(max_json_keys + 1)), "an object has more than 1000 keys");

    std::string values = "[0";
    while (values.size() < 2 * max_json_values) {
        values += ",0";
    }
    CHECK_THROWS_WITH(parse_json(values + "]"), "it has more than 1000000 values");
}
