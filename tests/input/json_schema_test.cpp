#include "input/json_schema.hpp"

#include "catch.hpp"

#include "io/tables/json_text.hpp"

using namespace ljmd;

namespace {

Data schema_of(const Schema& schema) {
    return parse_json(json_schema("decks", {{"force", "body"}, Schema("other"), schema}));
}

Data of_key(const Key& key) {
    return schema_of(Schema("one", {key})).at("else").at("properties").at(key.name);
}

}  // namespace

TEST_CASE("a JSON Schema says type, range, choices, default and meaning of each key") {
    CHECK(of_key(Key::flag("a").defaults_to(true).meaning("on or off")) ==
          Data::object({{"type", "boolean"}, {"default", true}, {"description", "on or off"}}));
    CHECK(of_key(Key::integer("n").at_least(1).below(9)) ==
          Data::object({{"type", "integer"}, {"minimum", 1.0}, {"exclusiveMaximum", 9.0}, {"description", ""}}));
    CHECK(of_key(Key::choice("c", {"x", "y"})).at("enum") == Data::list({"x", "y"}));
    const Data density = of_key(Key::number("density").dimension(Dimension::density).unit("sigma^-3").above(0.0));
    CHECK(density.at("anyOf") == Data::list({{{"type", "number"}, {"exclusiveMinimum", 0.0}}, {{"type", "string"}}}));
    CHECK(density.at("description").text().find("[sigma^-3; or in quotes ") != std::string::npos);
    const Data vector = of_key(Key::vector("r").components(2, 3).at_least(-1.0));
    CHECK(vector.at("items") == Data::object({{"type", "number"}, {"minimum", -1.0}}));
    CHECK(vector.at("minItems") == 2);
    CHECK(vector.at("maxItems") == 3);
    CHECK(of_key(Key::interval("every").at_least(1)).at("anyOf").size() == 2);
    CHECK(of_key(Key::text("t").optional("the name")).at("description") == "; without it: the name");
}

TEST_CASE("a JSON Schema says which keys must be there, and that there are no others") {
    const Data json = schema_of(
        Schema("one", {Key::text("a"), Key::text("b").optional(), Key::text("c").defaults_to(std::string("x"))}));
    CHECK(json.at("else").at("required") == Data::list({"a"}));
    CHECK(json.at("else").at("additionalProperties") == false);
    CHECK(json.at("if").at("anyOf").size() == 2);
    CHECK(json.at("title") == "decks");
}

TEST_CASE("a JSON Schema describes tables and arrays of tables") {
    const Schema inner("inner", {Key::integer("n")});
    CHECK(of_key(Key::table("t", inner)).at("properties").at("n").at("type") == "integer");
    CHECK(of_key(Key::tables("t", inner)).at("items").at("required") == Data::list({"n"}));
}

TEST_CASE("the keys of a choice are allowed with it alone, and with no choice those of the default") {
    const Data json = schema_of(Schema("one", {Key::choice("type", {"x", "y"}).defaults_to(std::string("x"))})
                                    .select("type", {{"x", {Key::number("a")}}, {"y", {Key::integer("b").optional()}}}))
                          .at("else");
    REQUIRE(json.at("allOf").size() == 2);
    const Data& x = json.at("allOf")[0];
    const Data& y = json.at("allOf")[1];
    CHECK_FALSE(x.at("if").contains("required"));
    CHECK(x.at("then").at("required") == Data::list({"a"}));
    CHECK(x.at("then").at("properties").at("b") == false);
    CHECK(y.at("if").at("required") == Data::list({"type"}));
    CHECK(y.at("if").at("properties").at("type").at("const") == "y");
    CHECK(y.at("then").at("properties").at("a") == false);
    CHECK(y.at("then").at("properties").at("b").at("type") == "integer");
}
