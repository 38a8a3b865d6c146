#include "cli/example_decks.hpp"

#include <algorithm>

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("examples are the decks of inputs, but for what starts from another run") {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(LJMD_INPUTS)) {
        const std::filesystem::path& path = entry.path();
        if (path.extension() == ".toml" && path.stem() != "continue") {
            INFO(path.string());
            CHECK(example_deck(path.stem().string()).text == content_of(path));
            ++files;
        }
    }
    CHECK(example_decks().size() == files);
    CHECK(example_names().size() == files);
    CHECK(example_deck("first").title() == "A small Lennard-Jones liquid");
}

TEST_CASE("of an unknown example the nearest one is named") {
    CHECK_THROWS_WITH(example_deck("pendulun"), Contains("no example is named 'pendulun'") && Contains("'pendulum'"));
    CHECK_THROWS_WITH(example_deck("?"), Contains("ljmd init --list"));
    CHECK_THROWS_AS(example_deck("continue"), InputError);
}
