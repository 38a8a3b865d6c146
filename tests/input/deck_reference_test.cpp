#include "input/deck_reference.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("a schema becomes a section of the reference page") {
    const Schema lattice("lattice", {Key::choice("type", {"fcc", "sc"}).defaults_to("fcc").meaning("a|b\nc")});
    const Schema system("[system]",
                        {
                            Key::number("density").above(0.0).at_most(1.5).unit("sigma^-3").meaning("N/V"),
                            Key::number("temperature").dimension(Dimension::temperature).unit("epsilon/k_B"),
                            Key::quantity("sigma", Dimension::length).optional(),
                            Key::table("lattice", lattice).optional("a start from `file`"),
                            Key::integer("seed").defaults_to(1967),
                            Key::number("skin").defaults_to(0.3),
                            Key::flag("tail").defaults_to(true),
                            Key::flag("sample").defaults_to(false),
                            Key::text("file").optional("no file"),
                            Key::vector("position").unit("sigma").meaning("start"),
                            Key::vector("masses").components(2, 2).above(0.0).defaults_to(std::vector{1.0, 0.5}),
                            Key::tables("stage", Schema("[[stage]]", {Key::text("name")})),
                        });
    CHECK(schema_markdown(system, 5) ==
          "##### `[system]`\n"
          "\n"
          "| key | type | unit | allowed | default | meaning |\n"
          "|---|---|---|---|---|---|\n"
          "| `density` | number | sigma^-3 | > 0, <= 1.5 | required | N/V |\n"
          "| `temperature` | number | epsilon/k_B; or in quotes K |  | required |  |\n"
          "| `sigma` | number with a unit, in quotes | angstrom, nm, pm or m |  | none |  |\n"
          "| `lattice` | table |  |  | a start from `file` |  |\n"
          "| `seed` | integer |  |  | 1967 |  |\n"
          "| `skin` | number |  |  | 0.3 |  |\n"
          "| `tail` | boolean |  | true or false | true |  |\n"
          "| `sample` | boolean |  | true or false | false |  |\n"
          "| `file` | string |  |  | no file |  |\n"
          "| `position` | array of 1 to 3 numbers | sigma |  | required | start |\n"
          "| `masses` | array of 2 numbers |  | each > 0 | [1, 0.5] |  |\n"
          "| `stage` | array of tables |  |  | required |  |\n"
          "\n"
          "###### `lattice`\n"
          "\n"
          "| key | type | unit | allowed | default | meaning |\n"
          "|---|---|---|---|---|---|\n"
          "| `type` | string |  | one of 'fcc', 'sc' | \"fcc\" | a\\|b c |\n"
          "\n"
          "###### `[[stage]]`\n"
          "\n"
          "| key | type | unit | allowed | default | meaning |\n"
          "|---|---|---|---|---|---|\n"
          "| `name` | string |  |  | required |  |\n");
    CHECK(schema_markdown(system, 6).find("###### `lattice`") != std::string::npos);
    CHECK(schema_markdown(system, 6).find("#######") == std::string::npos);
}

TEST_CASE("the keys of each choice have a table of their own") {
    Schema schema("[potential]", {Key::choice("truncation", {"cut", "switched"})});
    schema.select("truncation", {{"switched", {Key::number("switch_start").above(0.0)}}, {"cut", {}}});
    CHECK(schema_markdown(schema, 2).find("\nOnly with `truncation = \"switched\"`:\n\n"
                                          "| key | type | unit | allowed | default | meaning |\n"
                                          "|---|---|---|---|---|---|\n"
                                          "| `switch_start` | number |  | > 0 | required |  |\n") != std::string::npos);
    CHECK(schema_markdown(schema, 2).find("\"cut\"`:") == std::string::npos);
}
