#include "report/written_report.hpp"

#include "report/page.hpp"
#include "report/report_fixtures.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a page is written for a deck that asks for one, and for no other") {
    const DeckFolder folder(stars_deck);
    Deck deck = folder.load();
    run_whole(deck);
    const auto quiet = [](const std::string& text) { FAIL(text); };
    CHECK_FALSE(write_asked_report(deck, quiet));
    CHECK_FALSE(std::filesystem::exists(folder / "out" / report_name));
    deck.report = true;
    CHECK(write_asked_report(deck, quiet) == folder / "out" / report_name);
    CHECK_THAT(content_of(folder / "out" / report_name), Contains("\"kind\":\"few-body\"") && Contains("</html>"));
}

TEST_CASE("a page that cannot be made is a warning, not an error") {
    const DeckFolder folder;
    Deck deck = folder.load();
    deck.report = true;  // there has been no run
    std::string told;
    CHECK_FALSE(write_asked_report(deck, [&](const std::string& text) { told += text; }));
    CHECK_THAT(told, Contains("there is no report: "));
}

TEST_CASE("a page takes the place of an earlier one, and of another file by force alone") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    run_whole(deck);
    const std::filesystem::path page = folder / "page.html";
    for (int time = 1; time <= 2; ++time) {
        CHECK(write_report({deck.directory}, page).empty());
        CHECK(content_of(page).find(page_mark) < 4000);
    }
    std::ofstream(page) << "mine";
    CHECK_THROWS_AS(write_report({deck.directory}, page), OutputRefused);
    CHECK(content_of(page) == "mine");
    CHECK(write_report({deck.directory}, page, true).empty());
    CHECK(content_of(page) != "mine");
}
