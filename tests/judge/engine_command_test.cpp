#include "judge/engine_command.hpp"

#include <csignal>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

std::string complaint(const std::string& command, double seconds = 60.0) {
    const TemporaryFolder folder;
    try {
        run_engine(command, folder / "log", {.seconds = seconds, .folder = folder / "", .written = 1 << 20},
                   Interruption());
    } catch (const DataError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the names of directories become one word each") {
    CHECK(engine_command("./e {input} {output}", "/a", "/b") == "./e /a /b");
    CHECK(engine_command("e < {input}/start.xyz > {output}/x", "/a b", "/it's") ==
          "e < '/a b'/start.xyz > '/it'\\''s'/x");
    // What a name holds is not looked at again.
    CHECK(engine_command("e {input} {output}", "/{output}", "/{input}") == "e '/{output}' '/{input}'");
    CHECK(engine_command("e 'x' \"y\" {input} {input} {output} ${HOME}", "/a", "/b") == "e 'x' \"y\" /a /a /b ${HOME}");
}

TEST_CASE("a command that lacks a name or quotes one is refused") {
    CHECK_THROWS_WITH(engine_command("./e {input}", "/a", "/b"), Contains("{output} is missing"));
    CHECK_THROWS_WITH(engine_command("", "/a", "/b"), Contains("{input} is missing"));
    CHECK_THROWS_WITH(engine_command("./e '{input}' {output}", "/a", "/b"), Contains("within quotes"));
    CHECK_THROWS_WITH(engine_command("./e {input} \"x {output}\"", "/a", "/b"), Contains("within quotes"));
    CHECK_NOTHROW(engine_command("./e \\' {input} {output}", "/a", "/b"));
}

TEST_CASE("an engine that fails is an error with its last words") {
    CHECK(complaint("true").empty());
    CHECK_THAT(complaint("echo one; echo two >&2; exit 7"), Contains("exit status 7") && Contains("one\n  two"));
    CHECK_THAT(complaint("kill -9 $$"), Contains("signal 9 ended it; it has printed nothing"));
    CHECK_THAT(complaint("seq 100; false"), Contains("\n  95\n") && !Contains("\n  94\n"));
}

TEST_CASE("an engine that hangs is stopped with all that it has started") {
    CHECK_THAT(complaint("tail -f /dev/null & tail -f /dev/null", 0.2), Contains("stopped after 0.2 s"));
}

TEST_CASE("an engine that fills the disk is stopped, wherever within its folder it writes") {
    const TemporaryFolder folder;
    const std::string deeper = (folder / "a" / "b").string();
    CHECK_THROWS_WITH(
        run_engine("mkdir -p '" + deeper + "'; while :; do head -c 100000 /dev/zero >> '" + deeper + "/c'; done",
                   folder / "log", {.seconds = 1e9, .folder = folder / "a", .written = 1 << 20}, Interruption()),
        Contains("more than 0.00105 GB"));
    // What lies elsewhere does not count, nor what a link leads to.
    std::filesystem::create_directory_symlink("/usr", folder / "a" / "usr");
    CHECK_NOTHROW(run_engine("head -c 3000000 /dev/zero > '" + (folder / "elsewhere").string() + "'", folder / "log",
                             {.seconds = 1e9, .folder = folder / "a" / "b" / "d", .written = 1}, Interruption()));
}

TEST_CASE("a request to stop ends the engine, too") {
    const TemporaryFolder folder;
    const Interruption asked({}, [] { return std::optional(StopRequest{SIGTERM, "SIGTERM"}); });
    CHECK_THROWS_AS(run_engine("tail -f /dev/null", folder / "log", {.seconds = 1e9}, asked), Interrupted);
}
