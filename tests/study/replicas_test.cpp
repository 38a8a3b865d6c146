#include "study/replicas.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <set>

#include "io/files/directory_lock.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"
#include "study/replica_merge.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// The deck with a last stage that ends at these errors.
std::string until(const std::string& errors) {
    return changed(small_deck, {{"steps = 40", "until = { " + errors + ", max_steps = 40 }"}});
}

/// Run replicas in the directory, all to their end.
std::vector<ChildRun> run_all(const SweepPlan& plan, const fs::path& directory) {
    prepare_sweep(plan, directory, false);
    const std::vector<ChildRun> runs = sweep_runs(plan, directory);
    for (const ChildRun& run : runs) {
        Diagnostics diagnostics;
        auto deck = load_deck_text("deck.toml", run.source, run.settings, true, diagnostics);
        REQUIRE(deck.has_value());
        deck->directory = run.directory;
        prepare_directory(deck->directory);
        Recorder nobody;
        run_in(*deck, nobody);
    }
    return runs;
}

}  // namespace

TEST_CASE("replicas of decks with other seeds share no seed") {
    std::set<std::uint64_t> seeds;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        for (Index number = 1; number <= 50; ++number) {
            const std::uint64_t found = replica_seed(seed, number);
            CHECK(found < std::uint64_t{1} << 53U);
            seeds.insert(found);
        }
    }
    CHECK(seeds.size() == 2500);
    CHECK(replica_seed(42, 1) == replica_seed(42, 1));
}

TEST_CASE("replicas are a sweep over the seed, named after their numbers") {
    const DeckFolder folder(small_deck);
    const std::vector<std::string> settings{"system.seed=5", "system.temperature=1.5"};
    const SweepPlan plan = replica_plan(folder.load(settings), settings, 12);
    CHECK(plan.points.keys == std::vector<std::string>{"system.seed"});
    CHECK(plan.settings == std::vector<std::string>{"system.temperature=1.5"});
    REQUIRE(plan.points.values.size() == 12);
    CHECK(plan.points.values[1] == std::vector<std::string>{std::to_string(replica_seed(5, 2))});
    CHECK(sweep_runs(plan, "out")[1].name == "replica-02");
}

TEST_CASE("each replica runs to sqrt(n) times the error wanted") {
    const DeckFolder folder(until("pressure = 0.01, temperature = 0.5"));
    const SweepPlan plan = replica_plan(folder.load(), {"stage.production.until.pressure=0.01"}, 4);
    CHECK(plan.points.keys == std::vector<std::string>{"system.seed", "stage.production.until.temperature",
                                                       "stage.production.until.pressure"});
    CHECK(plan.settings.empty());
    CHECK(plan.points.values[0][1] == "1");
    CHECK(plan.points.values[0][2] == "0.02");
}

TEST_CASE("replicas that draw nothing at random are one run, many times") {
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    CHECK(why_all_the_same(deck, find_start(deck)).empty());  // velocities are drawn
}

TEST_CASE("the record of replicas is that of a sweep, with their number and the steps added to them") {
    const DeckFolder folder(small_deck);
    SweepPlan plan = replica_plan(folder.load(), {}, 2);
    const TemporaryFolder out;
    prepare_sweep(plan, out / "", false);
    CHECK(recorded_sweep(out / "")->replicas == 2);
    CHECK(recorded_sweep(out / "")->points == plan.points);
    plan.steps_added = 30;
    record_sweep(plan, OpenDirectory(out / ""));
    CHECK(recorded_sweep(out / "")->steps_added == 30);
    const SweepPlan three = replica_plan(folder.load(), {}, 3);
    CHECK_THROWS_WITH(prepare_sweep(three, out / "", false), Contains("another number of replicas"));
}

TEST_CASE("the results of replicas are merged") {
    const DeckFolder folder(small_deck + "[analysis]\nrdf = { bins = 10, every = 5 }\n");
    const Deck deck = folder.load({"stage.production.steps=400"});
    const SweepPlan plan = replica_plan(deck, {"stage.production.steps=400"}, 3);
    const TemporaryFolder out;
    const std::vector<ChildRun> runs = run_all(plan, out / "");
    const Document report = replicas_report(deck, runs, out / "");
    std::vector<ReplicaMean> means;
    for (const ChildRun& run : runs) {
        const Data found = parse_json(content_of(run.directory / "results.json"))["observables"]["pressure"];
        means.push_back({found["mean"].number(), found["standard_error"].number(), found["samples"].number(),
                         found["error_is_converged"].flag()});
    }
    const MergedMean expected = merged_mean(means);
    const Data& pressure = report.data["observables"]["pressure"];
    CHECK(pressure["mean"].number() == expected.mean);
    CHECK(pressure["standard_error"].number() == Approx(expected.standard_error));
    CHECK(pressure["standard_error_between"].number() == Approx(expected.between));
    CHECK(report.data["replicas"] == 3);
    CHECK_THAT(report.text, Contains("3 replicas, merged") && Contains("pressure"));

    write_replicas(report, runs, OpenDirectory(out / ""));
    CHECK(content_of(out / "results.txt") == report.text);
    CHECK(parse_json(content_of(out / "results.json")) == report.data);
    CHECK_THAT(content_of(out / "rdf.csv"), Contains("r,g,g_standard_error"));
}

TEST_CASE("what a replica does not tell is told of all, and nothing is lost without a word") {
    const DeckFolder folder(small_deck);
    const SweepPlan plan = replica_plan(folder.load({"stage.production.steps=400"}), {"stage.production.steps=400"}, 3);
    const TemporaryFolder out;
    const std::vector<ChildRun> runs = run_all(plan, out / "");
    const auto change = [&](std::size_t run, const std::function<void(Data&)>& work) {
        const fs::path path = runs[run].directory / "results.json";
        Data results = parse_json(content_of(path));
        work(results["observables"]);
        std::ofstream(path) << to_json(results);
    };
    const auto report = [&] { return replicas_report(folder.load(), runs, out / ""); };

    change(1, [](Data& all) {
        all["pressure"]["mean"] = nullptr;
        all["pressure"]["standard_error"] = nullptr;
        all["pressure"]["remark"] = "it is not known";
        all["potential_energy"]["remark"] = "it is odd";
    });
    const Document some = report();
    const Data& pressure = some.data["observables"]["pressure"];
    CHECK(pressure["mean"].is_null());
    CHECK_THAT(pressure["remark"].text(),
               Contains("1 of 3 replicas have no value") && Contains("in 1 of 3 replicas: it is not known"));
    CHECK_THAT(some.data["observables"]["potential_energy"]["remark"].text(),
               Contains("in 1 of 3 replicas: it is odd"));
    CHECK_THAT(some.text, Contains("it is not known") && Contains("it is odd"));

    change(2, [](Data& all) {
        const Data before = all;
        for (const auto& [name, entry] : before.members()) {
            all[name]["samples"] = 30;
        }
    });
    CHECK_THAT(report().text, Contains("the replicas have 30 to 40 samples: each counts by its length"));
}
