#include "ljmd/options/settings.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/section.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

std::vector<Key> keys() {
    return {Key::number("time").above(0.0), Key::integer("length").defaults_to(std::int64_t{3}),
            Key::choice("start", {"taylor", "euler"}).defaults_to(std::string("taylor")),
            Key::vector("axis").optional()};
}

}  // namespace

TEST_CASE("settings are told in words, with as many digits as tell them from others") {
    CHECK(settings_in_words({}).empty());
    CHECK(settings_in_words({{"time", 0.1}, {"length", 3}, {"on", true}, {"start", "taylor"}}) ==
          "time=0.1 length=3 on=true start=taylor");
    CHECK(settings_in_words({{"time", 0.1}}) != settings_in_words({{"time", 0.1 + 1e-16}}));
}

TEST_CASE("settings are checked like a table of a deck, and the others have their defaults") {
    const Section section = checked_settings("bath", keys(), {{"time", 2}, {"axis", std::vector<double>{1.0, 0.5}}});
    CHECK(section.plain("time") == PlainValue(2.0));
    CHECK(section.plain("length") == PlainValue(std::int64_t{3}));
    CHECK(section.plain("start") == PlainValue(std::string("taylor")));
    CHECK(section.plain("axis") == PlainValue(std::vector<double>{1.0, 0.5}));
}

TEST_CASE("all mistakes in settings are told at once, without a place") {
    CHECK_THROWS_AS(checked_settings("bath", keys(), {}), InputError);
    CHECK_THROWS_WITH(checked_settings("bath", keys(), {}), Contains("missing key 'time' in bath"));
    CHECK_THROWS_WITH(checked_settings("bath", keys(), {{"time", 1.0}, {"time", 2.0}}),
                      "'time' in bath is given twice");
    CHECK_THROWS_WITH(checked_settings("bath", keys(), {{"time", -1.0}, {"length", "long"}, {"star", "euler"}}),
                      Contains("'time' in bath") && Contains("> 0") && Contains("must be an integer") &&
                          Contains("unknown key 'star' in bath: did you mean 'start'?"));
}
