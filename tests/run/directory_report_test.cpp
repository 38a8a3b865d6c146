#include "run/directory_report.hpp"

#include <fmt/format.h>

#include "io/files/checkpoint_file.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("of a run that has ended its directory tells so, and how to make it longer") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_until(deck, total_steps(deck.stages()));
    const std::string text = directory_report(deck.directory).text;
    CHECK_THAT(text, Contains("A small liquid\n"));
    CHECK_THAT(text, Contains("finished      yes\n"));
    CHECK_THAT(text, Contains("checkpoint    after step 60 of 60, 40 of 40 in stage 'production'\n"));
    CHECK_THAT(text, Contains(fmt::format("longer: ljmd resume {} --steps +N\n", deck.directory.string())));
    for (const char* name : {"run.json", "results.json", "thermo.csv", "final.xyz"}) {
        CHECK_THAT(text, Contains(fmt::format("  {:<18}", name)));
    }
}

TEST_CASE("of a run that was stopped its directory tells how far it got, in words and as JSON") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 15);
    CHECK_THAT(directory_report(deck.directory).text,
               Contains("finished      no\n") && Contains("after step 10 of 60, 10 of 20 in stage 'equilibrate'\n") &&
                   Contains("to go on: ljmd resume "));
    const Data found = directory_report(deck.directory).data;
    CHECK(found["title"] == "A small liquid");
    CHECK(found["kind"] == "fluid");
    CHECK(found["finished"] == false);
    CHECK(found["total_steps"] == 60);
    CHECK(found["checkpoint"] == Data{{"step", 10}, {"stage", "equilibrate"}, {"atoms", 108}});
    CHECK(found["resumed_at_steps"] == Data::list());
    CHECK(found["damaged"] == Data::list());
    const Data::List& files = found["files"].items();
    const auto thermo =
        std::find_if(files.begin(), files.end(), [](const Data& file) { return file["name"] == "thermo.csv"; });
    REQUIRE(thermo != files.end());
    CHECK((*thermo)["bytes"] == std::filesystem::file_size(deck.directory / "thermo.csv"));
}

TEST_CASE("damaged checkpoints are told, and a directory without a sound one has none") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 15);
    for (const std::string& name : checkpoint_names()) {
        if (std::filesystem::exists(deck.directory / name)) {
            std::ofstream(deck.directory / name) << "nonsense";
        }
    }
    CHECK_THAT(directory_report(deck.directory).text,
               Contains("checkpoint    none\n") && Contains("damaged       no checkpoint can be used"));
    CHECK(directory_report(deck.directory).data["checkpoint"].is_null());
}

TEST_CASE("what is not the directory of a run is refused") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(directory_report(folder / "nowhere"), DataError);
}
