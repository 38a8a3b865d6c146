#include "options/key_paths.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

Schema example() {
    Schema thermostat("thermostat", {Key::choice("type", {"rescale", "langevin"})});
    thermostat.select("type", {{"rescale", {Key::integer("every")}}, {"langevin", {Key::number("time")}}});
    return Schema("the deck",
                  {Key::text("title"),
                   Key::table("system", Schema("[system]", {Key::number("density"), Key::number("temperature")})),
                   Key::tables("stage", Schema("[[stage]]", {Key::text("name"), Key::number("temperature"),
                                                             Key::table("thermostat", thermostat)})),
                   Key::tables("body", Schema("[[body]]", {Key::number("mass")}))});
}

std::vector<std::string> paths(const std::vector<KeyPlace>& places) {
    std::vector<std::string> found;
    for (const KeyPlace& place : places) {
        found.push_back(place.path);
    }
    return found;
}

}  // namespace

TEST_CASE("every key has the path that --set takes, keys of choices included") {
    CHECK(paths(key_places(example())) ==
          std::vector<std::string>{"title", "system", "system.density", "system.temperature", "stage",
                                   "stage.NAME.name", "stage.NAME.temperature", "stage.NAME.thermostat",
                                   "stage.NAME.thermostat.type", "stage.NAME.thermostat.time",
                                   "stage.NAME.thermostat.every", "body", "body.NUMBER.mass"});
    const KeyPlace density = key_places(example())[2];
    CHECK(density.name == "density");
    CHECK(density.table == "[system]");
    CHECK_FALSE(density.is_table);
}

TEST_CASE("a key is found in inner tables, but not where it is known already or in too many") {
    CHECK(paths(inner_places(example(), "density")) == std::vector<std::string>{"system.density"});
    CHECK(paths(inner_places(example(), "temperature")) ==
          std::vector<std::string>{"system.temperature", "stage.NAME.temperature"});
    CHECK(paths(inner_places(example(), "thermostat")) == std::vector<std::string>{"stage.NAME.thermostat"});
    CHECK(inner_places(example(), "title").empty());
    CHECK(inner_places(example(), "nothing").empty());
    const Key x = Key::number("x");
    const Schema many("many", {Key::table("a", Schema("a", {x})), Key::table("b", Schema("b", {x})),
                               Key::table("c", Schema("c", {x})), Key::table("d", Schema("d", {x}))});
    CHECK(inner_places(many, "x").empty());
}

TEST_CASE("the nearest key of inner tables is known") {
    CHECK(nearest_inner_name(example(), "densty") == "density");
    CHECK(nearest_inner_name(example(), "qqqqqqqqqqqq").empty());
}
