#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("help lists all commands but those that are hidden, and tells the options of one") {
    const std::string all = said([] { command({"help"}); }).out;
    for (const auto& one : all_commands()) {
        INFO(one->name());
        CHECK((all.find("\n  " + one->name() + " ") != std::string::npos) == (one->part() != Command::Part::hidden));
        CHECK_THAT(said([&] { command({"help", one->name()}); }).out, Contains("ljmd " + one->name()));
    }
    CHECK_THAT(said([] { command({"help", "--man"}); }).out, Catch::StartsWith(".TH LJMD 1"));
    CHECK_THROWS_WITH(command({"help", "rnu"}), Contains("did you mean 'run'?"));
}
