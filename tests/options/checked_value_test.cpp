#include "options/checked_value.hpp"

#include <cmath>
#include <limits>
#include <string>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/section.hpp"

using namespace ljmd;

namespace {

/// One value against one key of [table], without units.
struct Check {
    PlainValue result;
    Diagnostics diagnostics;

    /// "line:column message (hint)" for each mistake, a line each.
    [[nodiscard]] std::string mistakes() const {
        std::string all;
        for (const auto& [severity, where, message, hint] : diagnostics.entries()) {
            all += std::to_string(where.line) + ":" + std::to_string(where.column) + " " + message;
            all += hint.empty() ? "\n" : " (" + hint + ")\n";
        }
        return all;
    }
};

Check check(const Key& key, const Value& value) {
    Check done;
    const std::string title = "[table]";
    const std::optional<SubstanceUnits> no_units;
    done.result = checked_value({key, title, no_units, done.diagnostics}, value);
    return done;
}

Value value_of(auto data) {
    return {data, {}};
}

const double infinity = std::numeric_limits<double>::infinity();

/// An array at line 7, column 1, whose elements stand at columns 21, 22, ...
Value numbers(const std::vector<decltype(Value::data)>& elements) {
    Array array;
    for (const auto& element : elements) array.push_back({element, {{}, 7, 21 + static_cast<int>(array.size()), 1}});
    return {array, {{}, 7, 1, 1}};
}

}  // namespace

TEST_CASE("an integer where a number is wanted becomes a double, and -0 becomes +0") {
    const Key key = Key::number("x").at_least(0.0);
    const Check whole = check(key, value_of(std::int64_t{3}));
    CHECK(std::get<double>(whole.result) == 3.0);
    CHECK(whole.diagnostics.entries().empty());
    const Check zero = check(key, value_of(-0.0));
    CHECK_FALSE(std::signbit(std::get<double>(zero.result)));
    CHECK(zero.diagnostics.entries().empty());
}

TEST_CASE("a value of the wrong kind or out of range is reported once and replaced by one that the key allows") {
    const Key key = Key::integer("n").at_least(2).at_most(5);
    for (const Value& wrong : {value_of(std::int64_t{9}), value_of(1.5), value_of(std::string("3")), value_of(true)}) {
        const Check done = check(key, wrong);
        REQUIRE(done.diagnostics.entries().size() == 1);
        CHECK(done.diagnostics.entries()[0].message.starts_with("'n' in [table]"));
        const auto stand_in = std::get<std::int64_t>(done.result);
        CHECK(stand_in >= 2);
        CHECK(stand_in <= 5);
    }
}

TEST_CASE("the stand-in after a mistake is the default where there is one") {
    CHECK(std::get<double>(fallback_value(Key::number("x").above(0.0).defaults_to(0.3))) == 0.3);
    CHECK(std::get<double>(fallback_value(Key::number("x").above(0.0))) > 0.0);
    CHECK(std::get<std::string>(fallback_value(Key::choice("c", {"a", "b"}))) == "a");
}

TEST_CASE("an array of numbers becomes a vector: integers are numbers, and -0 becomes +0") {
    const Check done = check(Key::vector("position"), numbers({1.5, std::int64_t{-2}, -0.0}));
    CHECK(done.mistakes().empty());
    const auto position = std::get<std::vector<double>>(done.result);
    CHECK(position == std::vector{1.5, -2.0, 0.0});
    CHECK_FALSE(std::signbit(position[2]));
    CHECK(check(Key::vector("position"), numbers({1.0})).mistakes().empty());
    CHECK(check(Key::vector("v").components(4, 5), numbers({1.0, 1.0, 1.0, 1.0, 1.0})).mistakes().empty());
}

TEST_CASE("what is no array of as many numbers is one mistake at the array") {
    const Key key = Key::vector("position").above(0.0);
    CHECK(check(key, value_of(1.0)).mistakes() ==
          "0:0 'position' in [table] must be an array of 1 to 3 numbers, found a float (allowed: each > 0)\n");
    CHECK(check(Key::vector("position").components(2, 2), value_of(std::string("1"))).mistakes() ==
          "0:0 'position' in [table] must be an array of 2 numbers, found a string\n");
    CHECK(check(Key::vector("position"), value_of(Table{})).mistakes() ==
          "0:0 'position' in [table] must be an array of 1 to 3 numbers, found a table\n");
    CHECK(check(key, numbers({})).mistakes() == "7:1 'position' in [table] has 0 components, allowed: 1 to 3\n");
    CHECK(check(key, numbers({1.0, 1.0, 1.0, 1.0})).mistakes() ==
          "7:1 'position' in [table] has 4 components, allowed: 1 to 3\n");
    CHECK(check(Key::vector("position").components(2, 2), numbers({1.0})).mistakes() ==
          "7:1 'position' in [table] has 1 component, allowed: 2\n");
}

TEST_CASE("a mistake of a component is told at its own place") {
    const Key key = Key::vector("v").components(1, 9).at_least(0.0).at_most(5.0);
    const Check done = check(
        key, numbers({1.0, std::string("2"), true, -1.0, std::int64_t{6}, infinity, Array{}, std::string("2 m"), 5.0}));
    CHECK(done.mistakes() ==
          "7:22 component 2 of 'v' in [table] must be a number, found a string (remove the quotes)\n"
          "7:23 component 3 of 'v' in [table] must be a number, found a boolean (allowed: >= 0, <= 5)\n"
          "7:24 component 4 of 'v' in [table] is -1, allowed: >= 0, <= 5\n"
          "7:25 component 5 of 'v' in [table] is 6, allowed: >= 0, <= 5\n"
          "7:26 component 6 of 'v' in [table] must be finite, found inf (allowed: >= 0, <= 5)\n"
          "7:27 component 7 of 'v' in [table] must be a number, found an array (allowed: >= 0, <= 5)\n"
          "7:28 component 8 of 'v' in [table] takes no unit, found '2 m'\n");
    CHECK(std::get<std::vector<double>>(done.result) == std::vector{1.0, 1.0, 1.0, 0.0, 5.0, 5.0, 1.0, 1.0, 5.0});
    // An array of a wrong length is searched too.
    CHECK(check(Key::vector("v").components(1, 1), numbers({1.0, true})).mistakes() ==
          "7:1 'v' in [table] has 2 components, allowed: 1\n"
          "7:22 component 2 of 'v' in [table] must be a number, found a boolean\n");
}

TEST_CASE("the stand-in for a vector has as many components as allowed, each in range") {
    const Key key = Key::vector("v").components(2, 3).above(2.0);
    const auto stand_in = [&](const Value& value) { return std::get<std::vector<double>>(check(key, value).result); };
    CHECK(stand_in(value_of(1.0)) == std::vector{3.0, 3.0});
    CHECK(stand_in(numbers({})) == std::vector{3.0, 3.0});
    CHECK(stand_in(numbers({5.0})) == std::vector{5.0, 3.0});
    CHECK(stand_in(numbers({5.0, 6.0, 7.0, 8.0})) == std::vector{5.0, 6.0, 7.0});
    const Check with_default = check(Key::vector("v").defaults_to(std::vector{0.5}), numbers({true, 2.0}));
    CHECK(std::get<std::vector<double>>(with_default.result) == std::vector{1.0, 2.0});
    CHECK(std::get<std::vector<double>>(fallback_value(Key::vector("v").defaults_to(std::vector{0.5}))) ==
          std::vector{0.5});
}

TEST_CASE("a section holds vectors, and tells stand-ins from what was given") {
    const Schema schema("[[body]]", {Key::vector("position"), Key::vector("velocity").optional("at rest"),
                                     Key::vector("spin").defaults_to(std::vector{0.0, 1.0}), Key::number("mass")});
    Diagnostics diagnostics;
    const Section good = validate({{"position", {}, numbers({1.0, 0.0})}, {"mass", {}, value_of(1.0)}}, {}, schema,
                                  std::nullopt, diagnostics);
    CHECK(diagnostics.entries().empty());
    CHECK(std::get<std::vector<double>>(good.plain("position")) == std::vector{1.0, 0.0});
    CHECK(good.sound("position"));
    CHECK(good.location("position").line == 7);
    CHECK(std::get<std::vector<double>>(good.plain("spin")) == std::vector{0.0, 1.0});
    CHECK_FALSE(good.has("velocity"));
    CHECK_THROWS_AS(good.plain("velocity"), ContractViolation);

    const Section bad = validate({{"velocity", {}, numbers({1.0, true})}, {"spin", {}, numbers({})}}, {}, schema,
                                 std::nullopt, diagnostics);
    REQUIRE(diagnostics.entries().size() == 4);
    CHECK(diagnostics.entries()[0].message == "missing key 'position' in [[body]]");
    CHECK(diagnostics.entries()[0].hint == "an array of 1 to 3 numbers");
    for (const char* key : {"position", "velocity", "spin"}) {
        CHECK_FALSE(bad.sound(key));
        CHECK_FALSE(std::get<std::vector<double>>(bad.plain(key)).empty());
    }
}

TEST_CASE("hints say what a key allows") {
    CHECK(allowed_hint(Key::number("x").above(0.0).at_most(1.5)) == "allowed: > 0, <= 1.5");
    CHECK(allowed_hint(Key::choice("c", {"a", "b"})) == "one of 'a', 'b'");
    CHECK(allowed_hint(Key::table("t", Schema("[t]"))) == "write [t]");
    CHECK(allowed_hint(Key::text("t")).empty());
    CHECK(allowed_hint(Key::vector("v").above(0.0)) == "allowed: each > 0");
    CHECK(expected_kind(Key::integer("n")) == "an integer");
    CHECK(expected_kind(Key::flag("f")) == "true or false");
    CHECK(expected_kind(Key::number("x")) == "a number");
    CHECK(expected_kind(Key::vector("v")) == "an array of 1 to 3 numbers");
    CHECK(is_table_kind(Kind::tables));
    CHECK_FALSE(is_table_kind(Kind::flag));
}
