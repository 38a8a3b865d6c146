#include "catch.hpp"

#include "cli/command_words.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// What it draws is looked at by tests/cli/plots.py, with the program in its place: no scripts lie beside these tests.
TEST_CASE("plot says where it has looked for its scripts") {
    CHECK_THROWS_WITH(command({"plot", "runs/argon"}), Contains("neither in") && Contains("/analysis"));
}
