#include "deck/forecast.hpp"

#include <cmath>

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Forecast forecast_of(const std::vector<std::string>& settings) {
    const DeckFolder folder;
    const Deck deck = folder.load(settings);
    return forecast(deck, find_start(deck), Execution(execution_options(deck)));
}

}  // namespace

TEST_CASE("any start can be told the cost of, also one that no crystal of the deck's fits") {
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"system.lattice.cells=1", "system.density=0.4", "potential.cutoff=1"},
          {"system.density=1e-6", "potential.cutoff=20"},
          {"system.temperature=49", "stage.equilibrate.steps=0", "stage.production.steps=0"},
          {"system.lattice.cells=10", "potential.cutoff=8"}}) {
        INFO(settings.back());
        const Forecast cost = forecast_of(settings);
        CHECK((std::isfinite(cost.seconds) && cost.seconds > 0.0));
        CHECK((std::isfinite(cost.memory_bytes) && cost.memory_bytes > 0.0));
        CHECK((std::isfinite(cost.disk_bytes) && cost.disk_bytes > 0.0));
    }
}

TEST_CASE("what analyses cost is counted where a part of the fluid can show it") {
    const Forecast without = forecast_of({});
    const Forecast with =
        forecast_of({"analysis.chemical_potential.every=1", "analysis.chemical_potential.insertions=20000"});
    CHECK(with.seconds > 10.0 * without.seconds);
    CHECK(with.not_counted.empty());
    const std::string wide = "analysis.rdf.radius=12";  // more than half the edge of 4000 atoms
    CHECK(forecast_of({"system.lattice.cells=20", wide}).not_counted == std::vector<std::string>{"rdf"});
}

TEST_CASE("the report of a check tells atoms, box, stages and cost") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    const Document report = check_report(deck, find_start(deck), {2.5e9, 3.4e6, 5400.0, 1});
    const std::string& text = report.text;
    CHECK(report.data["atoms"] == 108);
    CHECK(report.data["seconds"] == 5400.0);
    CHECK_THAT(text, Catch::StartsWith(deck.path + ": the deck is good. Nothing was run.\n"));
    CHECK_THAT(text, Contains("atoms     108\n"));
    CHECK_THAT(text, Contains("5.12993 x 5.12993 x 5.12993 sigma^3, density 0.8 sigma^-3"));
    CHECK_THAT(text, Contains("cutoff    2 sigma, at most L/2 = 2.56496\n"));
    CHECK_THAT(text, Contains("'equilibrate': 20 steps of 0.004 tau = 0.08 tau\n"));
    CHECK_THAT(text, Contains("'production': 40 steps of 0.004 tau = 0.16 tau, sampled\n"));
    CHECK_THAT(text, Contains("about 2.5 GB") && Contains("about 3.4 MB in " + deck.directory.string()) &&
                         Contains("about 90 min on this machine with one thread\n"));
    const std::string small = check_report(deck, find_start(deck), {2.5e4, 999e3, 1.2, 4}).text;
    CHECK_THAT(small, Contains("about 25 kB") && Contains("about 999 kB") &&
                          Contains("about 2 s on this machine with 4 threads\n"));
    CHECK_THAT(check_report(deck, find_start(deck), {1.0, 1.0, 9000.0, 1}).text, Contains("about 2.5 h"));
    const Document partly = check_report(deck, find_start(deck), {1.0, 1.0, 9000.0, 1, {"rdf", "msd"}});
    CHECK_THAT(partly.text, Contains("with one thread, not counted rdf, msd\n"));
    CHECK(partly.data["analyses_not_counted"] == Data::list({"rdf", "msd"}));
}
