#include "cli/judge/judge_command.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

// What the command does is tested in tests/cli/judges.py; here, which options it takes.

namespace {

std::string complaint(const CrosscheckOptions& options) {
    try {
        check_engine_options(options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

const std::string command = "command:./engine {input} {output}";

}  // namespace

TEST_CASE("commands and files are engines, programs that ljmd knows are not") {
    CHECK(is_engine("command:./engine"));
    CHECK(is_engine("files:there"));
    for (const char* name : {"openmm", "lammps", "gsl", "", "command", "files"}) {
        CHECK_FALSE(is_engine(name));
    }
}

TEST_CASE("options that have no meaning for an engine are refused") {
    CHECK(complaint({.with = command}).empty());
    CHECK(complaint({.with = command, .parts = {"point", "trajectory"}, .timeout = "90s"}).empty());
    CHECK(complaint({.with = "files:there"}).empty());
    CHECK_THAT(complaint({.with = command, .platform = "CPU"}), Contains("--platform"));
    CHECK(complaint({.with = command, .parts = {"speed"}}).empty());
    CHECK_THAT(complaint({.with = "files:there", .parts = {"speed"}}), Contains("speed"));
    CHECK_THAT(complaint({.with = command, .steps = 5, .parts = {"point"}}), Contains("--steps"));
    CHECK_THAT(complaint({.with = command, .timeout = "-1s"}), Contains("--timeout"));
    CHECK_THAT(complaint({.with = "files:there", .timeout = "1s"}), Contains("--timeout"));
    CHECK_THAT(complaint({.with = "files:"}), Contains("the name of the directory is missing"));
    CHECK_THAT(complaint({.with = "command:./engine"}), Contains("{input} is missing"));
}
