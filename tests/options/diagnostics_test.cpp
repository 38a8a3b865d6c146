#include "ljmd/detail/options/diagnostics.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

std::shared_ptr<const Source> source(std::string text) {
    return std::make_shared<const Source>(Source{"argon.toml", std::move(text)});
}

std::string formatted(Location location, std::string message, std::string hint = {}) {
    return format({Severity::error, std::move(location), std::move(message), std::move(hint)});
}

}  // namespace

TEST_CASE("a diagnostic shows its line, the underline and the hint") {
    const auto deck = source("[system]\r\n\tdensty\t= 0.8442\r\n# \xC3\x85 x\n\n\n\n\n\n\nlast");
    CHECK(formatted({deck, 2, 2, 6}, "unknown key 'densty' in [system]", "did you mean 'density'?") ==
          "error: argon.toml:2:2: unknown key 'densty' in [system]\n"
          "  2 |  densty = 0.8442\n"
          "    |  ^^^^^^ did you mean 'density'?");
    CHECK(formatted({deck, 3, 5, 99}, "m") == "error: argon.toml:3:5: m\n  3 | # \xC3\x85 x\n    |     ^");
    CHECK(formatted({deck, 10, 5, 1}, "m") == "error: argon.toml:10:5: m\n  10 | last\n     |     ^");
    CHECK(formatted({deck, 99, 0, -3}, "m") == "error: argon.toml:99:0: m\n  99 | \n     | ^");
}

TEST_CASE("a diagnostic without a line has its hint below") {
    const auto set = std::make_shared<const Source>(Source{"--set system.densty=0.8", "system.densty=0.8"});
    CHECK(formatted({set}, "unknown key 'densty' in [system]", "did you mean 'density'?") ==
          "error: --set system.densty=0.8: unknown key 'densty' in [system]\n"
          "  did you mean 'density'?");
    CHECK(formatted({set}, "m") == "error: --set system.densty=0.8: m");
    CHECK(format({Severity::warning, {}, "time step is large", {}}) == "warning: time step is large");
}

TEST_CASE("no control character or endless text reaches the terminal") {
    const auto deck = source("key = \"\x1B[2J\"");
    CHECK(formatted({deck, 1, 1, 3}, "bad \x1B[2J\nkey", "h\x07") ==
          "error: argon.toml:1:1: bad ?[2J?key\n  1 | key = \"?[2J\"\n    | ^^^ h?");
    CHECK(formatted({}, std::string(1000, 'x')) == "error: " + std::string(400, 'x') + "...");
}

TEST_CASE("a long line is cut around the column") {
    const auto deck = source(std::string(300, 'a') + "B" + std::string(300, 'c'));
    const std::string inside = formatted({deck, 1, 301, 1}, "m");
    CHECK(inside == "error: argon.toml:1:301: m\n  1 | ..." + std::string(80, 'a') + "B" + std::string(79, 'c') +
                        "...\n    | " + std::string(83, ' ') + "^");
    CHECK(formatted({deck, 1, 2, 999}, "m") ==
          "error: argon.toml:1:2: m\n  1 | " + std::string(160, 'a') + "...\n    |  " + std::string(159, '^'));
    CHECK(formatted({deck, 1, 601, 1}, "m") ==
          "error: argon.toml:1:601: m\n  1 | ..." + std::string(160, 'c') + "\n    | " + std::string(162, ' ') + "^");
    CHECK(formatted({source(std::string(160, 'x')), 1, 1, 1}, "m").find("...") == std::string::npos);
}

TEST_CASE("errors are thrown together, in the order of the text") {
    Diagnostics diagnostics;
    diagnostics.warning({}, "only a doubt");
    CHECK_FALSE(diagnostics.has_errors());
    CHECK_NOTHROW(diagnostics.throw_if_errors());

    const auto deck = source("a\nb");
    diagnostics.error({deck, 2, 1, 1}, "second");
    CHECK(diagnostics.has_errors());
    CHECK_THROWS_WITH(diagnostics.throw_if_errors(),
                      "error: argon.toml:2:1: second\n  2 | b\n    | ^\n1 error. Nothing was run.");
    diagnostics.error({deck, 1, 1, 1}, "first");
    CHECK_THROWS_WITH(diagnostics.throw_if_errors(),
                      "error: argon.toml:1:1: first\n  1 | a\n    | ^\n"
                      "error: argon.toml:2:1: second\n  2 | b\n    | ^\n2 errors. Nothing was run.");
    CHECK(diagnostics.entries().size() == 3);
    CHECK_THROWS_AS(diagnostics.throw_if_errors(), InputError);
}

TEST_CASE("of very many errors the first are shown and all counted") {
    Diagnostics diagnostics;
    for (int i = 0; i < 1000; ++i) diagnostics.error({}, "mistake " + std::to_string(i));
    try {
        diagnostics.throw_if_errors();
        FAIL("nothing thrown");
    } catch (const InputError& error) {
        const std::string text = error.what();
        CHECK(text.find("mistake 49\n... and 950 more\n1000 errors. Nothing was run.") != std::string::npos);
        CHECK(text.find("mistake 50") == std::string::npos);
    }
}

TEST_CASE("nearest_name finds one slip of the finger and no more") {
    const std::vector<std::string> names{"density", "temperature", "seed", "lattice", "file"};
    CHECK(nearest_name("densty", names) == "density");
    CHECK(nearest_name("dnesity", names) == "density");
    CHECK(nearest_name("temprature", names) == "temperature");
    CHECK(nearest_name("sede", names) == "seed");
    CHECK(nearest_name("seed", names) == "seed");
    CHECK(nearest_name("pressure", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name("x", {}).empty());
    // A swap of neighbours counts once: "ab" is within a third of "ba", rounded up; two replacements are not.
    CHECK(nearest_name("ab", {"ba"}) == "ba");
    CHECK(nearest_name("ab", {"cd"}).empty());
    // Distance 2 of 6 letters is near, 3 of 6 is not; of equals the first wins.
    CHECK(nearest_name("abcdef", {"abcdxy"}) == "abcdxy");
    CHECK(nearest_name("abcdef", {"abcxyz"}).empty());
    CHECK(nearest_name("cut", {"cat", "cot"}) == "cat");
    CHECK(nearest_name(std::string(65, 'a'), {std::string(65, 'a')}).empty());
}

TEST_CASE("errors without their places are one a line, with hints, and without warnings") {
    Diagnostics diagnostics;
    CHECK(diagnostics.errors_without_places().empty());
    diagnostics.warning({}, "a remark");
    CHECK(diagnostics.errors_without_places().empty());
    diagnostics.error({}, "unknown key 'densty'", "did you mean 'density'?");
    diagnostics.error({}, "missing key 'type'");
    CHECK(diagnostics.errors_without_places() == "unknown key 'densty': did you mean 'density'?\nmissing key 'type'");
}
