#include "ljmd/core/checked_value.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "ljmd/core/schema.hpp"

using namespace ljmd;

namespace {

/// One value against one key of [table], without units.
struct Check {
    Scalar result;
    Diagnostics diagnostics;
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

TEST_CASE("hints say what a key allows") {
    CHECK(allowed_hint(Key::number("x").above(0.0).at_most(1.5)) == "allowed: > 0, <= 1.5");
    CHECK(allowed_hint(Key::choice("c", {"a", "b"})) == "one of 'a', 'b'");
    CHECK(allowed_hint(Key::table("t", Schema("[t]"))) == "write [t]");
    CHECK(allowed_hint(Key::text("t")).empty());
    CHECK(expected_kind(Kind::integer) == "an integer");
    CHECK(is_table_kind(Kind::tables));
    CHECK_FALSE(is_table_kind(Kind::flag));
}
