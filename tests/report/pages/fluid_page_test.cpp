#include "report/pages/fluid_page.hpp"

#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("the page of a finished run has verdicts, quantities, charts and atoms that fit together") {
    const DeckFolder folder;
    const Deck deck =
        folder.load({"output.thermo.every=1", "output.trajectory={ format = \"xyz\", every = 10, velocities = true }",
                     "analysis.rdf={ bins = 50, every = 5 }"});
    run_whole(deck);
    const PageContent page = fluid_page(run_facts(deck.directory));
    check_marks(page);
    CHECK(Data(page.warnings) == run_facts(deck.directory).results["warnings"]);
    CHECK_FALSE(verdict_on(page.verdicts, "equilibrium").words.empty());
    CHECK_FALSE(verdict_on(page.verdicts, "error bars").words.empty());
    CHECK_NOTHROW(quantity_called(page.quantities, "temperature"));
    CHECK_NOTHROW(chart_called(page, "rdf-g"));
    CHECK_NOTHROW(table_called(page, "equilibration"));
    CHECK(page.atoms["frames"] == 7);
    CHECK(page.atoms["shown_atoms"] == 108);
    CHECK(page.atoms["steps"][6] == 60);
    CHECK(page.atoms["colours"][0]["name"] == "speed");
}

TEST_CASE("a run that measures a crystal is not judged as a fluid that has not melted") {
    const DeckFolder folder;
    const Deck deck = folder.load({"analysis.crystal={ every = 5 }"});
    run_whole(deck);
    const PageContent page = fluid_page(run_facts(deck.directory));
    check_marks(page);
    CHECK(verdict_on(page.verdicts, "crystal").level == "good");
    CHECK_THAT(verdict_on(page.verdicts, "equilibrium").words, !Contains("of the crystal was left"));
    CHECK_THAT(verdict_on(page.verdicts, "equation of state").words, Contains("this run measures a crystal"));
    CHECK_NOTHROW(chart_called(page, "bragg-debye_waller_factor"));
}

TEST_CASE("a run without a trajectory shows its last configuration, a failed one where it stopped") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_whole(deck);
    const PageContent page = fluid_page(run_facts(deck.directory));
    CHECK(page.atoms["frames"] == 1);
    CHECK_THAT(page.atoms["words"].text(), Contains("the run has no trajectory"));
    run_until(deck, 30);
    std::filesystem::rename(folder / "out/thermo.csv", folder / "out/gone");
    CHECK(fluid_page(run_facts(deck.directory)).atoms.is_null());
}

TEST_CASE("of a run that goes on, or has damaged files, the page has what is there") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.thermo.every=1", "output.trajectory={ format = \"xyz\", every = 10 }"});
    run_until(deck, 40);
    const PageContent page = fluid_page(run_facts(deck.directory));
    check_marks(page);
    CHECK(page.warnings.empty());
    CHECK_NOTHROW(quantity_called(page.quantities, "temperature"));
    CHECK(page.atoms["frames"].integer() >= 4);

    overwrite(deck.directory / "thermo.csv", "step,time\n0,0,0\n");
    overwrite(deck.directory / "trajectory.xyz", "108\nnonsense\n");
    const PageContent damaged = fluid_page(run_facts(deck.directory));
    check_marks(damaged);
    CHECK(damaged.warnings.size() >= 2);
    CHECK(verdict_on(damaged.verdicts, "equilibrium").level == "unknown");

    overwrite(deck.directory / "run.json", "{\"program\": \"ljmd\", \"kind\": \"fluid\", \"finished\": false}");
    CHECK_FALSE(fluid_page(run_facts(deck.directory)).warnings.empty());
}
