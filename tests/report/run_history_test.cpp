#include <cmath>

#include "io/tables/data_table_csv.hpp"
#include "report/report_fixtures.hpp"
#include "report/run_charts.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("a long table is shown in part, from its first row on, and says how long it is") {
    DataTable table{"t", {"time", "y"}, {}};
    for (int k = 0; k < 1001; ++k) {
        table.rows.push_back({0.1 * k, 1.0 * k});
    }
    CHECK(thinned(table, 1001).rows.size() == 1001);
    const DataTable shown = thinned(table, 1000);
    CHECK(shown.rows.size() == 501);
    CHECK(shown.rows.back()[1] == 1000.0);
    const PageTable page = page_table(table, "T", "t.csv", {"y", "missing"}, 100);
    CHECK(page.columns.size() == 1);
    CHECK(page.rows == 1001);
    CHECK(values_of(page, "y").size() == 91);
}

TEST_CASE("time series have block averages of the sampled rows, whose mean is the result") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=1"});
    run_whole(deck);
    const RunFacts facts = run_facts(deck.directory);
    PageContent page{.kind = "run", .title = "", .source = ""};
    add_history(page, facts);
    check_marks(page);
    double sum = 0.0;
    const Data::List& blocks = values_of(table_called(page, "blocks"), "temperature");
    REQUIRE(blocks.size() == 20);
    for (const Data& block : blocks) {
        sum += block.number();
    }
    CHECK(sum / 20.0 == Approx(facts.results["observables"]["temperature"]["mean"].number()).epsilon(1e-7));
    CHECK(values_of(table_called(page, "energy"), "energy_change")[0] == 0.0);
    CHECK(chart_called(page, "energy").lead);
    CHECK(chart_called(page, "temperature").marks[0].label == deck.stages()[1].name);
    CHECK(chart_called(page, "temperature").marks[0].value.value() ==
          Approx(static_cast<double>(deck.stages()[0].steps) * deck.stages()[0].time_step));
}

TEST_CASE("blocking curves begin at one, and are left out of short runs") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=1", "stage.production.steps=100"});
    run_whole(deck);
    PageContent page{.kind = "run", .title = "", .source = ""};
    add_blocking_curves(page, run_facts(deck.directory));
    check_marks(page);
    const PageTable& table = table_called(page, "blocking");
    CHECK(values_of(table, "length")[0] == 1);
    CHECK(values_of(table, "error_ratio")[0] == 1);
    CHECK(values_of(table, "error_ratio")[1].number() > 1.2);  // successive rows of a liquid are correlated

    const Deck shorter = folder.load({"output.thermo.every=5"});
    run_whole(shorter);
    PageContent empty{.kind = "run", .title = "", .source = ""};
    add_blocking_curves(empty, run_facts(shorter.directory));
    CHECK(empty.charts.empty());
}
