#include "ljmd/detail/options/section.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

using Mistakes = std::vector<std::string>;

const auto deck = std::make_shared<const Source>(Source{"deck.toml", ""});
const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
const double inf = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

template <class Data>
Entry entry(std::string key, Data data, int line = 1) {
    return {std::move(key), {deck, line, 1, 1}, {std::move(data), {deck, line, 9, 1}}};
}

/// "message | hint" for each mistake, in the order in which they were found.
Mistakes texts(const Diagnostics& diagnostics) {
    Mistakes found;
    for (const Diagnostic& diagnostic : diagnostics.entries()) {
        found.push_back(diagnostic.message + (diagnostic.hint.empty() ? "" : " | " + diagnostic.hint));
    }
    return found;
}

/// One key of a table [t] given one value.
struct One {
    template <class Data>
    One(Key key, Data data, const std::optional<SubstanceUnits>& units = std::nullopt)
        : section(validate({entry(key.name, std::move(data))}, {deck}, Schema("[t]", {key}), units, diagnostics)) {}

    Diagnostics diagnostics;
    Section section;
    [[nodiscard]] Mistakes mistakes() const { return texts(diagnostics); }
};

std::string text(const char* words) {
    return words;
}

Key density() {
    return Key::number("density").above(0.0).at_most(1.5).dimension(Dimension::density);
}
Key temperature() {
    return Key::number("temperature").at_least(0.0).dimension(Dimension::temperature);
}
Key steps() {
    return Key::integer("steps").at_least(0);
}
Key truncation() {
    return Key::choice("truncation", {"cut", "shifted", "switched"});
}
Key sigma() {
    return Key::quantity("sigma", Dimension::length).above(0.0);
}

}  // namespace

TEST_CASE("good values arrive as they are") {
    const Schema lattice("lattice", {Key::integer("cells").at_least(1)});
    const Schema stage("[[stage]]", {Key::text("name"), Key::flag("sample").defaults_to(false)});
    const Schema schema("[all]", {density(), steps(), truncation(), Key::flag("tail"), Key::text("title").optional(),
                                  Key::number("skin").defaults_to(0.3), Key::table("lattice", lattice),
                                  Key::tables("stage", stage), Key::table("other", lattice).optional()});
    const Array stages{{Table{entry("name", text("a"), 7)}, {deck, 6, 1, 9}},
                       {Table{entry("name", text("b")), entry("sample", true)}, {deck, 8, 1, 9}}};
    Diagnostics diagnostics;
    const Section all = validate(
        {entry("density", 0.8442, 2), entry("steps", std::int64_t{5}), entry("truncation", text("cut")),
         entry("tail", true), entry("lattice", Table{entry("cells", std::int64_t{6})}, 5), entry("stage", stages)},
        {deck, 1, 1, 5}, schema, std::nullopt, diagnostics);
    CHECK(texts(diagnostics).empty());
    CHECK(std::get<double>(all.plain("density")) == 0.8442);
    CHECK(std::get<std::int64_t>(all.plain("steps")) == 5);
    CHECK(std::get<std::string>(all.plain("truncation")) == "cut");
    CHECK(std::get<bool>(all.plain("tail")));
    CHECK(std::get<double>(all.plain("skin")) == 0.3);
    CHECK(std::get<std::int64_t>(all.section("lattice").plain("cells")) == 6);
    CHECK(all.section("lattice").title() == "lattice");
    REQUIRE(all.sections("stage").size() == 2);
    CHECK(std::get<std::string>(all.sections("stage")[0].plain("name")) == "a");
    CHECK_FALSE(std::get<bool>(all.sections("stage")[0].plain("sample")));
    CHECK(std::get<bool>(all.sections("stage")[1].plain("sample")));

    CHECK(all.has("skin"));
    CHECK_FALSE(all.has("title"));
    CHECK_FALSE(all.has("other"));
    CHECK_FALSE(all.has("nonsense"));
    CHECK(all.knows("title"));
    CHECK_FALSE(all.knows("nonsense"));
    CHECK(all.title() == "[all]");
    CHECK(all.location("density").line == 2);
    CHECK(all.location("density").column == 9);
    CHECK(all.location("skin").line == 1);
    CHECK(all.location("title").length == 5);
    CHECK(all.location("nonsense").line == 1);
    CHECK(all.section("lattice").location().line == 5);
    CHECK(all.sections("stage")[0].location().line == 6);
}

TEST_CASE("asking a section for what it cannot have is a mistake of the program") {
    const One one(density().optional(), 0.5);
    CHECK_THROWS_AS(one.section.section("density"), ContractViolation);
    CHECK_THROWS_AS(one.section.sections("density"), ContractViolation);
    CHECK_THROWS_AS(one.section.plain("skin"), ContractViolation);
    Diagnostics diagnostics;
    const Section empty = validate({}, {}, Schema("[t]", {density().optional()}), std::nullopt, diagnostics);
    CHECK_THROWS_AS(empty.plain("density"), ContractViolation);
}

TEST_CASE("what is written is told from a default, and how often something happens is known by its key") {
    const Schema schema("[t]", {Key::integer("pace").at_least(1).defaults_to(std::int64_t{4}).step_interval(), steps(),
                                Key::integer("rest").optional().step_interval()});
    Diagnostics diagnostics;
    const Section usual = validate({entry("steps", std::int64_t{3}, 2)}, {deck, 1}, schema, std::nullopt, diagnostics);
    CHECK(usual.written("steps"));
    CHECK_FALSE(usual.written("pace"));
    CHECK_FALSE(usual.written("rest"));
    REQUIRE(usual.step_interval().has_value());
    CHECK(usual.step_interval()->every == 4);
    CHECK(usual.step_interval()->location.line == 1);
    CHECK(usual.all_sound());
    const Section given = validate({entry("steps", std::int64_t{3}), entry("pace", std::int64_t{7}, 3)}, {deck, 1},
                                   schema, std::nullopt, diagnostics);
    CHECK(given.written("pace"));
    REQUIRE(given.step_interval().has_value());
    CHECK(given.step_interval()->every == 7);
    CHECK(given.step_interval()->location.line == 3);
    CHECK_FALSE(One(density(), 0.5).section.step_interval().has_value());
    CHECK_FALSE(validate({}, {deck, 1}, schema, std::nullopt, diagnostics).all_sound());
    CHECK_THROWS_AS(density().step_interval(), ContractViolation);
}

TEST_CASE("mistakes are reported at their keys, unless the value was found wrong before") {
    Diagnostics diagnostics;
    const Section section = validate({entry("density", -1.0, 2), entry("steps", std::int64_t{3}, 3)}, {deck, 1},
                                     Schema("[t]", {density(), steps()}), std::nullopt, diagnostics);
    Diagnostics found;
    report_at_keys({{"density", "too thin"}, {"steps", "too few"}}, section, found);
    CHECK(texts(found) == Mistakes{"too few"});
    CHECK_THROWS_AS(report_at_keys({{"stps", "too few"}}, section, found), ContractViolation);
    REQUIRE(found.entries().size() == 1);
    CHECK(found.entries()[0].location.line == 3);
}

TEST_CASE("numbers: type, range, finiteness") {
    CHECK(std::get<double>(One(density(), std::int64_t{1}).section.plain("density")) == 1.0);
    CHECK(One(density(), 1.5).mistakes().empty());
    CHECK(One(density(), -1.0).mistakes() == Mistakes{"'density' in [t] is -1, allowed: > 0, <= 1.5"});
    CHECK(One(density(), std::int64_t{2}).mistakes() == Mistakes{"'density' in [t] is 2, allowed: > 0, <= 1.5"});
    CHECK(One(density(), 0.0).mistakes() == Mistakes{"'density' in [t] is 0, allowed: > 0, <= 1.5"});
    CHECK(One(density(), -0.0).mistakes() == Mistakes{"'density' in [t] is -0, allowed: > 0, <= 1.5"});
    CHECK(One(Key::number("x").below(2.0), 2.0).mistakes() == Mistakes{"'x' in [t] is 2, allowed: < 2"});
    CHECK(One(density(), nan_value).mistakes() ==
          Mistakes{"'density' in [t] must be finite, found nan | allowed: > 0, <= 1.5"});
    CHECK(One(density(), -inf).mistakes() ==
          Mistakes{"'density' in [t] must be finite, found -inf | allowed: > 0, <= 1.5"});
    CHECK(One(Key::number("x"), inf).mistakes() == Mistakes{"'x' in [t] must be finite, found inf"});
    CHECK(One(density(), true).mistakes() ==
          Mistakes{"'density' in [t] must be a number, found a boolean | allowed: > 0, <= 1.5"});
    CHECK(One(density(), Date{"1967-07-05"}).mistakes() ==
          Mistakes{"'density' in [t] must be a number, found a date | allowed: > 0, <= 1.5"});

    const One zero(temperature(), -0.0);
    CHECK(zero.mistakes().empty());
    CHECK_FALSE(std::signbit(std::get<double>(zero.section.plain("temperature"))));
}

TEST_CASE("integers: no float, no boolean, in range") {
    const std::int64_t most = std::numeric_limits<std::int64_t>::max();
    CHECK(std::get<std::int64_t>(One(steps(), most).section.plain("steps")) == most);
    CHECK(One(steps(), 5.0).mistakes() == Mistakes{"'steps' in [t] must be an integer, found a float | allowed: >= 0"});
    CHECK(One(steps(), true).mistakes() ==
          Mistakes{"'steps' in [t] must be an integer, found a boolean | allowed: >= 0"});
    CHECK(One(steps(), text("5")).mistakes() ==
          Mistakes{"'steps' in [t] must be an integer, found a string | remove the quotes"});
    CHECK(One(steps(), text("5 steps")).mistakes() ==
          Mistakes{"'steps' in [t] must be an integer, found a string | allowed: >= 0"});
    CHECK(One(steps(), std::int64_t{-7}).mistakes() == Mistakes{"'steps' in [t] is -7, allowed: >= 0"});
}

TEST_CASE("intervals: a number of steps, or a wall time") {
    const Key every = Key::interval("every").at_least(1).at_most(100).defaults_to("5 min");
    const One steps(every, std::int64_t{7});
    CHECK(steps.mistakes().empty());
    CHECK(steps.section.plain("every") == PlainValue(std::int64_t{7}));
    const One time(every, text("2 h"));
    CHECK(time.mistakes().empty());
    CHECK(time.section.plain("every") == PlainValue(text("2 h")));
    CHECK(One(every, std::int64_t{0}).mistakes() ==
          Mistakes{"'every' in [t] is 0, allowed: >= 1, <= 100 steps, or a number > 0 with s, min, h or d, in quotes"});
    CHECK(One(every, text("often")).mistakes() ==
          Mistakes{"'every' in [t]: 'often' is no wall time | allowed: >= 1, <= 100 steps, or a number > 0 with s, "
                   "min, h or d, in quotes"});
    CHECK(One(every, 2.5).mistakes().size() == 1);
    CHECK(One(every, true).mistakes().size() == 1);
    CHECK(One(every, std::int64_t{1000}).section.plain("every") == PlainValue(std::int64_t{100}));
    CHECK(One(every, text("-1 s")).section.plain("every") == PlainValue(text("5 min")));
}

TEST_CASE("flags, texts and choices") {
    CHECK(One(Key::flag("tail"), text("true")).mistakes() ==
          Mistakes{"'tail' in [t] must be true or false, found a string | remove the quotes"});
    CHECK(One(Key::flag("tail"), std::int64_t{1}).mistakes() ==
          Mistakes{"'tail' in [t] must be true or false, found an integer"});
    CHECK(One(Key::text("name"), std::int64_t{1}).mistakes() ==
          Mistakes{"'name' in [t] must be a string, found an integer | put it in quotes"});
    CHECK(One(Key::text("name"), Array{}).mistakes() == Mistakes{"'name' in [t] must be a string, found an array"});
    CHECK(One(truncation(), text("shiftd")).mistakes() ==
          Mistakes{"'truncation' in [t] is 'shiftd', allowed: one of 'cut', 'shifted', 'switched' | did you mean "
                   "'shifted'?"});
    CHECK(One(truncation(), text("none")).mistakes() ==
          Mistakes{"'truncation' in [t] is 'none', allowed: one of 'cut', 'shifted', 'switched'"});
    CHECK(One(truncation(), false).mistakes() ==
          Mistakes{"'truncation' in [t] must be a string, found a boolean | one of 'cut', 'shifted', 'switched'"});
    CHECK(One(truncation(), std::string(5000, 'x')).mistakes().front().size() < 200);
}

TEST_CASE("numbers with units become reduced") {
    const One warm(temperature(), text("86.5 K"), argon);
    CHECK(warm.mistakes().empty());
    CHECK(std::get<double>(warm.section.plain("temperature")) == Approx(86.5 / 119.8).epsilon(1e-14));
    CHECK(One(temperature(), text("86.5 K")).mistakes() ==
          Mistakes{"'temperature' in [t]: unit 'K' needs an [argon] table"});
    CHECK(One(temperature(), text("-599 K"), argon).mistakes() ==
          Mistakes{"'temperature' in [t] is '-599 K' (-5 in reduced units), allowed: >= 0"});
    for (const auto& units : {std::optional<SubstanceUnits>{}, std::optional(argon)}) {
        CHECK(One(density(), text("0.8"), units).mistakes() ==
              Mistakes{"'density' in [t] must be a number, found a string | remove the quotes"});
        CHECK(One(density(), text("thick"), units).mistakes() ==
              Mistakes{"'density' in [t] must be a number, found a string | allowed: > 0, <= 1.5"});
        CHECK(One(density(), text("1 parsec"), units).mistakes() ==
              Mistakes{"'density' in [t]: 'parsec' is no unit of density, allowed: g/cm3 or kg/m3"});
        CHECK(One(temperature(), text("3 nm"), units).mistakes() ==
              Mistakes{"'temperature' in [t]: 'nm' is no unit of temperature, allowed: K"});
        CHECK(One(Key::number("x"), text("3 nm"), units).mistakes() ==
              Mistakes{"'x' in [t] takes no unit, found '3 nm'"});
    }
    // 1e308 Pa is finite, but not in the units of so thin a substance.
    const SubstanceUnits thin(1.0, 1e-30, 1.0);
    CHECK(One(Key::number("p").dimension(Dimension::pressure), text("1e300 Pa"), thin).mistakes() ==
          Mistakes{"'p' in [t] must be finite, found '1e300 Pa' (inf in reduced units)"});
}

TEST_CASE("quantities always have a unit and stay in SI") {
    const One good(sigma(), text("3.405 angstrom"));
    CHECK(good.mistakes().empty());
    CHECK(std::get<double>(good.section.plain("sigma")) == Approx(3.405e-10).epsilon(1e-15));
    CHECK(
        One(sigma(), 3.405).mistakes() ==
        Mistakes{"'sigma' in [t] must be a number with a unit, in quotes, found a float | allowed: angstrom, nm, pm or "
                 "m"});
    for (const char* none : {"3.405", "wide", "nan nm"}) {
        CHECK(One(sigma(), text(none)).mistakes() ==
              Mistakes{text("'sigma' in [t] must be a number with a unit, found '") + none +
                       "' | allowed: angstrom, nm, pm or m"});
    }
    CHECK(One(sigma(), text("3 K")).mistakes() ==
          Mistakes{"'sigma' in [t]: 'K' is no unit of length | allowed: angstrom, nm, pm or m"});
    CHECK(One(sigma(), text("-3 nm")).mistakes() == Mistakes{"'sigma' in [t] is '-3 nm', allowed: > 0"});
}

TEST_CASE("unknown and missing keys") {
    const Schema schema("[t]", {density(), truncation(), Key::flag("tail"), Key::text("name"), sigma()});
    Diagnostics diagnostics;
    const Section section = validate(
        {entry("densty", 0.8, 4), entry("colour", 1.0), entry("stuff", Table{}), entry("body", Array{{Table{}, {}}})},
        {deck, 3, 1, 3}, schema, std::nullopt, diagnostics);
    const std::string known = " | known keys: density, truncation, tail, name, sigma";
    CHECK(texts(diagnostics) ==
          Mistakes{"unknown key 'densty' in [t] | did you mean 'density'?", "unknown key 'colour' in [t]" + known,
                   "unknown table 'stuff' in [t]" + known, "unknown table 'body' in [t]" + known,
                   "missing key 'truncation' in [t] | one of 'cut', 'shifted', 'switched'",
                   "missing key 'tail' in [t] | true or false", "missing key 'name' in [t] | a string",
                   "missing key 'sigma' in [t] | allowed: angstrom, nm, pm or m"});
    CHECK(diagnostics.entries()[0].location.line == 4);
    CHECK(diagnostics.entries()[0].location.column == 1);
    CHECK(diagnostics.entries()[4].location.line == 3);

    Diagnostics none;
    static_cast<void>(validate({entry("a", 1.0)}, {deck}, Schema("[t]"), std::nullopt, none));
    CHECK(texts(none) == Mistakes{"unknown key 'a' in [t] | no keys are known here"});
}

TEST_CASE("a key that belongs to an inner table is told where it belongs: as a path where it was set, else by table") {
    const Schema schema("the deck",
                        {Key::table("system", Schema("[system]", {density()})).optional(),
                         Key::tables("stage", Schema("[[stage]]", {Key::text("name"), steps()})).optional()});
    Diagnostics diagnostics;
    static_cast<void>(validate({entry("density", 0.8, 0), entry("steps", 1.0, 0), entry("densty", 0.8, 0),
                                entry("density", 0.8, 4), entry("steps", 1.0, 5)},
                               {deck}, schema, std::nullopt, diagnostics));
    CHECK(texts(diagnostics) == Mistakes{"unknown key 'density' in the deck | did you mean 'system.density'?",
                                         "unknown key 'steps' in the deck | did you mean 'stage.NAME.steps'?",
                                         "unknown key 'densty' in the deck | did you mean 'system.density'?",
                                         "unknown key 'density' in the deck | did you mean 'density' in [system]?",
                                         "unknown key 'steps' in the deck | did you mean 'steps' in [[stage]]?"});
}

TEST_CASE("a key of another choice is told where it belongs") {
    Schema schema("[t]", {Key::choice("type", {"lj", "mie", "morse"})});
    schema.select("type", {{"mie", {Key::number("n"), Key::number("m")}}, {"morse", {Key::number("m")}}});
    const auto checked = [&](const char* type, const Table& more) {
        Table table{entry("type", text(type))};
        table.insert(table.end(), more.begin(), more.end());
        Diagnostics diagnostics;
        static_cast<void>(validate(table, {deck}, schema, std::nullopt, diagnostics));
        return texts(diagnostics);
    };
    CHECK(checked("mie", {entry("n", 12.0), entry("m", 6.0)}).empty());
    CHECK(checked("mie", {entry("n", 12.0)}) == Mistakes{"missing key 'm' in [t] | a number"});
    CHECK(checked("lj", {entry("n", 12.0), entry("m", 6.0)}) ==
          Mistakes{"key 'n' in [t] goes only with type = 'mie'",
                   "key 'm' in [t] goes only with type = 'mie' or 'morse'"});
    CHECK(checked("mei", {entry("n", 12.0)}) ==
          Mistakes{"'type' in [t] is 'mei', allowed: one of 'lj', 'mie', 'morse' | did you mean 'mie'?"});
}

TEST_CASE("tables and arrays of tables") {
    const Schema lattice("lattice", {Key::integer("cells").at_least(1)});
    const Schema system("[system]", {density()});
    const Schema stage("[[stage]]", {steps()});
    CHECK(One(Key::table("lattice", lattice), std::int64_t{6}).mistakes() ==
          Mistakes{"'lattice' in [t] must be a table, found an integer"});
    CHECK(One(Key::table("system", system), Array{}).mistakes() ==
          Mistakes{"'system' in [t] must be a table, found an array | write [system]"});
    CHECK(One(Key::tables("stage", stage), Table{}).mistakes() ==
          Mistakes{"'stage' in [t] must be an array of tables, found a table | write [[stage]]"});
    CHECK(One(Key::tables("stage", stage), Array{}).mistakes() ==
          Mistakes{"'stage' in [t] is empty | write [[stage]]"});
    CHECK(One(Key::tables("stage", stage).optional(), Array{}).mistakes().empty());
    const One mixed(Key::tables("stage", stage), Array{{1.0, {}}, {Table{entry("steps", -1.0)}, {}}});
    CHECK(mixed.mistakes() == Mistakes{"'stage' in [t] must be an array of tables, found a float | write [[stage]]",
                                       "'steps' in [[stage]] must be an integer, found a float | allowed: >= 0"});
    CHECK(mixed.section.sections("stage").size() == 1);

    Diagnostics missing;
    const Section root =
        validate({}, {deck}, Schema("the deck", {Key::table("system", system), Key::tables("stage", stage)}),
                 std::nullopt, missing);
    CHECK(texts(missing) == Mistakes{"missing table 'system' in the deck | write [system]",
                                     "missing table 'stage' in the deck | write [[stage]]"});
    CHECK(std::get<double>(root.section("system").plain("density")) > 0.0);
    CHECK(root.sections("stage").empty());
}

TEST_CASE("after a mistake every value can be used") {
    CHECK(std::get<double>(One(temperature(), -1.0).section.plain("temperature")) == 0.0);
    CHECK(std::get<double>(One(density(), 2.0).section.plain("density")) == 1.5);
    CHECK(std::get<double>(One(density(), -2.0).section.plain("density")) == 1.0);
    CHECK(std::get<double>(One(density(), nan_value).section.plain("density")) == 1.0);
    CHECK(std::get<double>(One(density(), inf).section.plain("density")) == 1.5);
    CHECK(std::get<double>(One(density(), text("1 g/cm3")).section.plain("density")) == 1.0);
    CHECK(std::get<double>(One(Key::number("x").above(2.0), 1.0).section.plain("x")) == 3.0);
    CHECK(std::get<double>(One(Key::number("x").above(2.0).below(4.0), 1.0).section.plain("x")) == 3.0);
    CHECK(std::get<double>(One(Key::number("x").below(-4.0), 1.0).section.plain("x")) == -5.0);
    CHECK(std::get<double>(One(Key::number("x").above(0.0).below(1.0).defaults_to(0.25), -1.0).section.plain("x")) ==
          0.25);
    CHECK(std::get<double>(One(Key::number("x").above(0.0).below(0.0), -1.0).section.plain("x")) == 0.0);
    CHECK(std::get<std::int64_t>(One(steps(), std::int64_t{-1}).section.plain("steps")) == 0);
    CHECK(std::get<std::int64_t>(One(Key::integer("x").above(3), std::int64_t{3}).section.plain("x")) == 4);
    CHECK(std::get<std::int64_t>(One(steps(), text("x")).section.plain("steps")) == 1);
    CHECK_FALSE(std::get<bool>(One(Key::flag("tail"), 1.0).section.plain("tail")));
    CHECK(std::get<std::string>(One(truncation(), text("switchd")).section.plain("truncation")) == "switched");
    CHECK(std::get<std::string>(One(truncation(), text("?")).section.plain("truncation")) == "cut");
    CHECK(std::get<std::string>(One(Key::text("name"), 1.0).section.plain("name")).empty());
    CHECK(std::get<double>(One(sigma(), text("wide")).section.plain("sigma")) == 1.0);
}

TEST_CASE("a section tells stand-ins from what was given") {
    CHECK(One(density(), 0.8).section.sound("density"));
    CHECK_FALSE(One(density(), -0.8).section.sound("density"));
    CHECK_FALSE(One(density(), text("dense")).section.sound("density"));
    CHECK_FALSE(One(Key::table("system", Schema("[system]")), 1.0).section.sound("system"));
    CHECK_FALSE(One(Key::tables("stage", Schema("[[stage]]")), 1.0).section.sound("stage"));
    CHECK(One(Key::table("system", Schema("[system]", {density()})), Table{entry("density", -1.0)})
              .section.sound("system"));

    const Schema schema("[t]", {density().optional(), temperature(), truncation().optional(), sigma().optional()});
    Diagnostics diagnostics;
    const Section section = validate({entry("densty", 0.8)}, {deck}, schema, std::nullopt, diagnostics);
    CHECK_FALSE(section.sound("density"));      // misspelled
    CHECK_FALSE(section.sound("temperature"));  // missing
    CHECK(section.sound("truncation"));         // may be left out
    CHECK(section.sound("pressure"));           // not of the schema
}

TEST_CASE("a missing vector is told how many numbers it has") {
    Diagnostics diagnostics;
    const Schema schema("[[body]]", {Key::vector("position").at_least(-1e100).at_most(1e100)});
    static_cast<void>(validate({}, {}, schema, std::nullopt, diagnostics));
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK(diagnostics.entries()[0].message == "missing key 'position' in [[body]]");
    CHECK(diagnostics.entries()[0].hint == "an array of 1 to 3 numbers");
}
