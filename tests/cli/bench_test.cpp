#include "cli/bench.hpp"

#include "catch.hpp"

#include "io/tables/json_text.hpp"
#include "run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;

TEST_CASE("a benchmark runs the deck as it is and tells energies, times and memory") {
    const test::DeckFolder folder(test::small_deck + "[neighbors]\nevery = 7\n[performance]\nprecision = \"mixed\"\n");
    Deck deck = folder.load();
    Start start = find_start(deck);
    const Execution execution(execution_options(deck, 2));
    const BenchResult result = bench(deck, std::move(start), execution);
    CHECK(result.atoms == 108);
    CHECK(result.steps == 60);
    CHECK(result.rebuilds >= 60 / 7);
    CHECK(result.seconds.force > 0.0);
    CHECK(result.bytes_per_atom > 0.0);
    CHECK_FALSE(std::filesystem::exists(deck.directory));  // it runs elsewhere

    const auto json = parse_json(bench_json(result));
    CHECK(json.at("precision") == "mixed");
    CHECK(json.at("threads") == 2);
    CHECK(json.at("simd") == name(default_simd_level()));
    CHECK(json.at("lists") == "every 7 steps, pairs may be missed");
    CHECK(json.at("atom_steps_per_second").number() == Approx(108 * 60 / result.seconds.sum()));
    CHECK(json.at("seconds_per_phase").size() == 6);

    // The same run by the same code gives the same energies.
    FluidSystem simulation = make_fluid(fluid_spec(deck, find_start(deck)), execution, [](const std::string&) {});
    prepare_directory(deck.directory);
    test::Recorder nobody;
    const RunResult run = run_plan(deck, simulation, nobody);
    CHECK(json.at("total_energy_final").number() == run.last.total_energy);
    CHECK(json.at("potential_energy_initial").number() == run.first.potential_energy);
    CHECK(result.last.temperature == run.last.temperature);
}

TEST_CASE("the report of a benchmark has a line for each phase") {
    BenchResult result{};
    result.atoms = 1000;
    result.steps = 100;
    result.precision = "double";
    result.seconds = {1.0, 0.5, 0.25, 0.125, 0.0625, 0.0625};
    const std::string report = bench_report(result);
    for (const char* word : {"force", "list", "sort", "integrate", "observe", "write", "all", "0.05 million"}) {
        CHECK_THAT(report, Catch::Contains(word));
    }
}

TEST_CASE("the deck that is built in is the Lennard-Jones melt of 32000 atoms") {
    const test::DeckFolder folder{std::string(melt_deck())};
    const Deck deck = folder.load();
    CHECK(find_start(deck).atoms == 32000);
    CHECK(total_steps(deck.stages()) == 100);
}
