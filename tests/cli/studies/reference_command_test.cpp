#include "ljmd/cli/studies/reference_command.hpp"

#include <filesystem>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

// The runs are made by the tests in tests/cli/references.py: they are processes of the program.

TEST_CASE("a reference that is refused touches nothing") {
    const test::TemporaryFolder folder;
    ReferenceOptions options;
    options.request.temperature = 1.0;
    options.request.density = 0.3;
    options.out = (folder / "out").string();
    options.quiet = true;
    CHECK_THROWS_WITH(reference_command(options), Contains("separates into vapour and liquid"));
    options.request.density = 0.8;
    options.properties = {"entropy"};
    CHECK_THROWS_WITH(reference_command(options), Contains("unknown property 'entropy'"));
    options.properties.clear();
    for (const char* wrong : {"energy", "energy=", "=0.1", "energy=small", ""}) {
        options.errors = {wrong};
        CHECK_THROWS_AS(reference_command(options), InputError);
    }
    CHECK_FALSE(std::filesystem::exists(options.out));
}
