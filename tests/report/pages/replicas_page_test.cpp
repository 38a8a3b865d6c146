#include "report/pages/study_pages.hpp"
#include "report/report_fixtures.hpp"
#include "study/replicas.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("replicas have a page of their merged results, with each of them beside") {
    const TemporaryFolder out;
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    const SweepPlan plan = replica_plan(deck, {}, 2);
    prepare_sweep(plan, out / "", false);
    const std::vector<ChildRun> runs = sweep_runs(plan, out / "");
    CHECK(replicas_page(out / "").charts.empty());
    for (const ChildRun& run : runs) {
        Diagnostics diagnostics;
        auto one = load_deck_text("deck.toml", run.source, run.settings, true, diagnostics);
        REQUIRE(one.has_value());
        one->directory = run.directory;
        run_whole(*one);
    }
    write_replicas(replicas_report(deck, runs, out / ""), runs, OpenDirectory(out / ""));
    const PageContent page = replicas_page(out / "");
    check_marks(page);
    CHECK(page.state == "finished");
    CHECK(page.points.size() == 2);
    CHECK(values_of(table_called(page, "replicas"), "replica") == Data::List{"replica-1", "replica-2"});
    CHECK(chart_called(page, "pressure").marks.back().type == "rule-y");
    CHECK_FALSE(page.quantities.empty());
}
