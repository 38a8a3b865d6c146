#include "cli/shown_run.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("results are printed as words or as JSON, and no page is written unasked") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    Progress progress(108, 60, true);
    const auto results = [] { return Document{{{"steps", 60}}, "60 steps\n"}; };
    CHECK(said([&] { show_run(deck, progress, false, results); }).out == "60 steps\n");
    const Said json = said([&] { show_run(deck, progress, true, results); });
    CHECK(json.out == "{\n  \"steps\": 60\n}\n");
    CHECK(json.err.empty());
}
