#include "cli/command_words.hpp"
#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("complete says what the last word of a command line can be, and takes any words") {
    const auto complete = [](std::vector<std::string> words) {
        words.insert(words.begin(), {"complete", "--"});
        return said([&] { command(words); }).out;
    };
    CHECK_THAT(complete({"resu"}), Catch::StartsWith("resume\tresume a run that was stopped"));
    CHECK_THAT(complete({""}), Contains("\nversion\t") && !Contains("\ncomplete\t"));
    CHECK_THAT(complete({"check", "--quiet", "--precision", "m"}), Catch::StartsWith("mixed\t"));
    CHECK(complete({"run", "--walltime", ""}).empty());
    CHECK(complete({"nothing", "--"}).empty());
    CHECK(said([] { command({"complete"}); }).out == complete({""}));
}
