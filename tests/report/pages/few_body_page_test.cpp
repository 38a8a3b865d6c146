#include "report/pages/few_body_page.hpp"

#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("the page of stars has tracks, paths, the error of the energy and what the analyses found") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load({"output.trajectory={ every = 5 }", "analysis.orbit={ body = 1, about = 2 }"});
    run_whole(deck);
    const RunFacts facts = run_facts(deck.directory);
    const PageContent page = few_body_page(facts);
    check_marks(page);
    CHECK(page.warnings.empty());
    CHECK(page.kind == "few-body");
    CHECK(page.tracks["bodies"].size() == 2);
    CHECK(page.tracks["times"].size() == 20);
    CHECK(chart_called(page, "orbit").equal_axes);
    CHECK(chart_called(page, "energy").lead);
    CHECK(verdict_on(page.verdicts, "energy").level == "good");
    CHECK(values_of(table_called(page, "totals"), "at_start")[0].number() ==
          Approx(facts.results["observables"]["potential_energy"]["at_start"].number()));
    CHECK_FALSE(page.quantities.empty());
}

TEST_CASE("bodies move on the page whatever the format of their trajectory") {
    const DeckFolder folder(stars_deck);
    const auto tracks = [&](const std::string& format) {
        Deck deck = folder.load({"output.trajectory={ every = 5, velocities = true, format = \"" + format + "\" }"});
        deck.directory /= format;
        run_whole(deck);
        const PageContent page = few_body_page(run_facts(deck.directory));
        check_marks(page);
        INFO(format);
        CHECK(page.warnings.empty());
        CHECK(chart_called(page, "orbit").equal_axes);
        CHECK(table_called(page, "trajectory").file == "trajectory." + format);
        return page.tracks;
    };
    const Data of_csv = tracks("csv");
    CHECK(of_csv["times"].size() == 20);
    CHECK(tracks("xyz") == of_csv);
    CHECK(tracks("h5md") == of_csv);
}

TEST_CASE("one coordinate has a phase portrait, and an energy that is lost is told") {
    const DeckFolder folder(radial_deck);
    const Deck deck =
        folder.load({"output.trajectory={ every = 1 }", "stage.out.time_step=0.5", "stage.out.steps=200"});
    run_whole(deck);
    const PageContent page = few_body_page(run_facts(deck.directory));
    check_marks(page);
    CHECK(chart_called(page, "phase").lead);
    CHECK(verdict_on(page.verdicts, "energy").level != "good");
}

TEST_CASE("without rows there are no charts") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    run_whole(deck);
    overwrite(deck.directory / "thermo.csv", "step,time,total_energy\n");
    CHECK(few_body_page(run_facts(deck.directory)).charts.empty());
}
