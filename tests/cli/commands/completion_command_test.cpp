#include "cli/command_words.hpp"
#include "cli/pages/completion.hpp"
#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("completion prints the script of a shell, of those that there are") {
    for (const std::string& shell : completed_shells()) {
        CHECK(said([&] { command({"completion", shell}); }).out == completion_script(shell));
    }
    CHECK_THROWS_AS(command({"completion", "tcsh"}), CLI::ParseError);
    CHECK_THROWS_AS(command({"completion"}), CLI::ParseError);
}
