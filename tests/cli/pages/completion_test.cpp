#include "ljmd/cli/pages/completion.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

#include "cli/pages/made_tree.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("keys of decks of both kinds are completed, tables are not") {
    const std::vector<std::string> keys = all_deck_keys();
    for (const char* key : {"system.density", "stage.NAME.time_step", "body.NUMBER.mass", "output.thermo.every"}) {
        INFO(key);
        CHECK(std::ranges::find(keys, key) != keys.end());
    }
    CHECK(std::ranges::find(keys, "system") == keys.end());
    CHECK(std::ranges::is_sorted(keys));
}

TEST_CASE("each shell has its own script, and no other one has any") {
    CHECK(completion(made_tree(), "bash") == bash_completion(made_tree()));
    CHECK(completion(made_tree(), "fish") == fish_completion(made_tree()));
    CHECK(completion(made_tree(), "zsh") == zsh_completion(made_tree()));
    CHECK_THROWS_AS(completion(made_tree(), "tcsh"), InputError);
}
