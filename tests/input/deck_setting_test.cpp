#include "input/deck_setting.hpp"

#include <algorithm>
#include "catch.hpp"

#include "input/deck_file.hpp"
#include "io/parsed_deck.hpp"
#include "ljmd/detail/options/section.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

const std::string argon_deck = R"(title = "Liquid argon"
units = "reduced"

[system]
lattice = { type = "fcc", cells = 6 }
density = 0.8442
temperature = "86.5 K"

[[stage]]
name = "equilibrate"
steps = 5_000

[[stage]]
name = "production"
steps = 20000

[[body]]
mass = 1
position = [0.0, 0.5]

[[body]]
mass = 2.5
position = [-1.0, 0]
)";

Schema argon_schema() {
    const Schema system("[system]", {Key::number("density").above(0.0).at_most(1.5)});
    const Schema stage("[[stage]]", {Key::text("name"), Key::integer("steps").at_least(0)});
    const Schema body("[[body]]", {Key::number("mass").above(0.0), Key::vector("position")});
    return Schema("the deck", {Key::table("system", system), Key::tables("stage", stage), Key::tables("body", body)});
}

/// A table after settings that must succeed.
Table with_settings(const std::vector<std::string>& settings) {
    Table table = parsed(argon_deck);
    Diagnostics diagnostics;
    for (const std::string& setting : settings) apply_setting(table, setting, diagnostics);
    CHECK(formatted(diagnostics).empty());
    return table;
}

/// The error of a setting that must fail, without "error: ".
std::string bad_setting(const std::string& setting) {
    Table table = parsed(argon_deck);
    Diagnostics diagnostics;
    apply_setting(table, setting, diagnostics);
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK(table.size() == 5);
    return format(diagnostics.entries().front()).substr(7);
}

}  // namespace

TEST_CASE("a setting replaces or adds a value") {
    const Table table =
        with_settings({"system.density=0.5", "system.temperature=86 K", "units=real # no comment",
                       " output . directory = \"runs/a=b\"", "analysis.msd.origins=50", "stage.production.steps=7",
                       "stage.\"equilibrate\".sample=true", "system.lattice={ type = \"sc\", cells = [1] }", "title="});
    CHECK(std::get<double>(at(inner(table, "system"), "density").data) == 0.5);
    CHECK(std::get<std::string>(at(inner(table, "system"), "temperature").data) == "86 K");
    CHECK(std::get<std::string>(at(table, "units").data) == "real # no comment");
    CHECK(std::get<std::string>(at(inner(table, "output"), "directory").data) == "runs/a=b");
    CHECK(std::get<std::int64_t>(at(inner(inner(table, "analysis"), "msd"), "origins").data) == 50);
    CHECK(std::get<std::string>(at(table, "title").data).empty());
    const auto& stages = std::get<Array>(at(table, "stage").data);
    CHECK(std::get<std::int64_t>(at(std::get<Table>(stages[0].data), "steps").data) == 5000);
    CHECK(std::get<std::int64_t>(at(std::get<Table>(stages[1].data), "steps").data) == 7);
    CHECK(std::get<bool>(at(std::get<Table>(stages[0].data), "sample").data));
    const Table& lattice = inner(inner(table, "system"), "lattice");
    CHECK(lattice[0].key_location.line == 0);
    CHECK(std::get<Array>(lattice[1].value.data)[0].location.source->name.find("--set system.lattice=") == 0);
    // Text that only looks like TOML at its start is text.
    const Table lines = with_settings({"title=1\nb = 2", "units=[1, 2"});
    CHECK(std::get<std::string>(at(lines, "title").data) == "1\nb = 2");
    CHECK(std::get<std::string>(at(lines, "units").data) == "[1, 2");
}

TEST_CASE("what is set has the place of its value, so that it differs from a table that is made for it") {
    const Table table = with_settings({"output.thermo.every=5", "system.lattice={ type = \"sc\", cells = 2 }"});
    const Entry& thermo = *find(inner(table, "output"), "thermo");
    CHECK(thermo.value.location.column == 0);
    CHECK(at(inner(inner(table, "output"), "thermo"), "every").location.column == 21);
    CHECK(at(inner(table, "system"), "lattice").location.column == 16);
    CHECK(at(inner(inner(table, "system"), "lattice"), "cells").location.column == 39);
    CHECK(at(inner(inner(table, "system"), "lattice"), "cells").location.line == 0);
}

TEST_CASE("a setting whose key comes again is told to have no effect") {
    Table table = parsed(argon_deck);
    Diagnostics diagnostics;
    for (const char* setting : {"system.density=0.5", "stage.production.steps=7", "system.density=0.6"}) {
        apply_setting(table, setting, diagnostics);
    }
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK(format(diagnostics.entries().front()) ==
          "warning: --set system.density=0.5: has no effect: --set system.density=0.6 comes after it");
    CHECK(std::get<double>(at(inner(table, "system"), "density").data) == 0.6);
}

TEST_CASE("a table without a name is reached by its number") {
    const Table table = with_settings(
        {"body.2.mass=0.5", "body.2.position=[1.0, 0, -2e-3]", "body.1.label=sun", "body.\"1\".spin.axis=[0, 1]"});
    const auto& bodies = std::get<Array>(at(table, "body").data);
    const Table& first = std::get<Table>(bodies[0].data);
    const Table& second = std::get<Table>(bodies[1].data);
    CHECK(std::get<std::int64_t>(at(first, "mass").data) == 1);
    CHECK(std::get<double>(at(second, "mass").data) == 0.5);
    CHECK(std::get<std::string>(at(first, "label").data) == "sun");
    CHECK(std::get<Array>(at(inner(first, "spin"), "axis").data).size() == 2);
    const auto& position = std::get<Array>(at(second, "position").data);
    REQUIRE(position.size() == 3);
    CHECK(std::get<double>(position[0].data) == 1.0);
    CHECK(std::get<std::int64_t>(position[1].data) == 0);
    CHECK(std::get<double>(position[2].data) == -2e-3);
    CHECK(position[2].location.source->name == "--set body.2.position=[1.0, 0, -2e-3]");

    Diagnostics diagnostics;
    const Section deck = validate(with_settings({"body.2.position=[1.0, 0]"}), {},
                                  Schema("the deck", {argon_schema().keys().back()}), std::nullopt, diagnostics);
    CHECK(std::get<std::vector<double>>(deck.sections("body")[1].plain("position")) == std::vector{1.0, 0.0});
    CHECK(std::get<std::vector<double>>(deck.sections("body")[0].plain("position")) == std::vector{0.0, 0.5});
}

TEST_CASE("a number that no table has is one error") {
    CHECK(bad_setting("body.3.mass=1") ==
          "--set body.3.mass=1: no 'body' has the number 3\n  there are 2 [[body]] tables, counted from 1");
    for (const std::string number : {"0", "00", "18446744073709551617", "99999999999999999999999"}) {
        CHECK(bad_setting("body." + number + ".mass=1").find("no 'body' has the number " + number + "\n") !=
              std::string::npos);
    }
    for (const std::string name : {"sun", "-1", "1x", "+1"}) {
        CHECK(bad_setting("body." + name + ".mass=1")
                  .find("no 'body' is named '" + name + "'\n  its elements are reached by number: body.1.KEY=VALUE") !=
              std::string::npos);
    }
    CHECK(bad_setting("body.1=1") ==
          "--set body.1=1: 'body' is an array, not a table\n"
          "  its elements are reached by number: body.1.KEY=VALUE");
    CHECK(bad_setting("body.1.position.1=0.5") ==
          "--set body.1.position.1=0.5: 'position' is an array, not a table\n  it is set as a whole: position=[...]");
    // Where there are names a number is one of them, or a mistake.
    CHECK(bad_setting("stage.1.steps=1") ==
          "--set stage.1.steps=1: no 'stage' is named '1'\n  known names: equilibrate, production");

    Table single = parsed("[[body]]\nmass = 1");
    Diagnostics diagnostics;
    apply_setting(single, "body.2.mass=1", diagnostics);
    CHECK(formatted(diagnostics) == std::vector<std::string>{"error: --set body.2.mass=1: no 'body' has the number 2\n"
                                                             "  there is 1 [[body]] table, counted from 1"});
}

TEST_CASE("a setting that cannot be applied is one error") {
    CHECK(bad_setting("system.density") == "--set system.density: a setting has the form KEY=VALUE");
    CHECK(bad_setting("=5") == "--set =5: the key, or a part of it, is empty");
    for (const char* key : {" =5", "a..b=5", ".a=5", "a.=5", "\"a=5"}) {
        CHECK(bad_setting(key).find("the key, or a part of it, is empty") != std::string::npos);
    }
    std::string deep = "a";
    for (int i = 0; i < 100; ++i) deep += ".a";
    CHECK(bad_setting(deep + "=1").find("the key has too many parts") != std::string::npos);
    CHECK(bad_setting("system.density.x=1") == "--set system.density.x=1: 'density' is a float, not a table");
    CHECK(bad_setting("stage.production=1") ==
          "--set stage.production=1: 'stage' is an array, not a table\n"
          "  its elements are reached by name: stage.NAME.KEY=VALUE");
    CHECK(bad_setting("stage.prodution.steps=1") ==
          "--set stage.prodution.steps=1: no 'stage' is named 'prodution'\n"
          "  did you mean 'production'? known names: equilibrate, production");
    CHECK(bad_setting("stage.x.steps=1") ==
          "--set stage.x.steps=1: no 'stage' is named 'x'\n  known names: equilibrate, production");
    CHECK(bad_setting("system.seed=99999999999999999999").find(": '99999999999999999999' does not fit in 64 bits") !=
          std::string::npos);
    CHECK(bad_setting("system.x=1e400").find("too large for a number") != std::string::npos);
    CHECK(bad_setting("title=\xFF") == "--set title=?: invalid UTF-8");
    CHECK(bad_setting("\xFF=1").find("invalid UTF-8") != std::string::npos);
    CHECK(bad_setting("title=" + std::string(10000, '[')).find("nested deeper than 32 levels") != std::string::npos);

    Table numbers = parsed("a = [1, 2]");
    Diagnostics diagnostics;
    apply_setting(numbers, "a.first.x=1", diagnostics);
    CHECK(formatted(diagnostics) == std::vector<std::string>{"error: --set a.first.x=1: 'a' is an array, not a table\n"
                                                             "  it is set as a whole: a=[...]"});
}

TEST_CASE("a mistake in a setting is told as one of the setting") {
    Table table = parsed(argon_deck);
    Diagnostics diagnostics;
    apply_setting(table, "system.densty=0.8", diagnostics);
    apply_setting(table, "stage.production.steps=-1", diagnostics);
    apply_setting(table, "body.2.position=[0, x]", diagnostics);
    apply_setting(table, "body.1.position=[0, '1']", diagnostics);
    static_cast<void>(validate(table, {}, argon_schema(), std::nullopt, diagnostics));
    const auto all = formatted(diagnostics);
    CHECK(std::count(all.begin(), all.end(),
                     "error: --set system.densty=0.8: unknown key 'densty' in [system]\n"
                     "  did you mean 'density'?") == 1);
    CHECK(std::count(all.begin(), all.end(),
                     "error: --set stage.production.steps=-1: 'steps' in [[stage]] is -1, allowed: >= 0") == 1);
    CHECK(std::count(all.begin(), all.end(),
                     "error: --set body.2.position=[0, x]: 'position' in [[body]] must be an array of 1 to 3 numbers, "
                     "found a string") == 1);
    CHECK(std::count(all.begin(), all.end(),
                     "error: --set body.1.position=[0, '1']: component 2 of 'position' in [[body]] must be a number, "
                     "found a string\n"
                     "  remove the quotes") == 1);
}

TEST_CASE("the parts of a key stand between dots, in quotes or not") {
    using Parts = std::vector<std::string>;
    CHECK(setting_key("stage.production.steps") == Parts{"stage", "production", "steps"});
    CHECK(setting_key(" system . \"density\"") == Parts{"system", "density"});
    CHECK(setting_key("stage.'a.b'.steps") == Parts{"stage", "a.b", "steps"});
    for (const char* text : {"", ".", "a.", ".a", "a..b", "a.\"b", "''"}) {
        INFO(text);
        CHECK(setting_key(text).empty());
    }
}
