#include "study/study_report.hpp"

#include "io/files/claimed_file.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"
#include "study/sweep_record.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// A run of a study, begun and stopped after this step, or run to its end.
void leave_run(const ChildRun& run, Index last_step) {
    Diagnostics diagnostics;
    auto deck = load_deck_text("deck.toml", run.source, run.settings, false, diagnostics);
    REQUIRE(deck.has_value());
    deck->directory = run.directory;
    run_until(*deck, last_step);
}

}  // namespace

TEST_CASE("of a sweep its directory tells how far each run got, in words and as JSON") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    const SweepPlan plan{"some.toml", small_deck, {}, {{"system.temperature"}, {{"1"}, {"2"}, {"3"}, {"4"}}}};
    prepare_sweep(plan, out, false);
    REQUIRE(holds_study(out));
    const auto runs = sweep_runs(plan, out);
    leave_run(runs[0], 60);
    leave_run(runs[1], 30);
    std::ofstream(runs[2].log) << "error: blown up\n";

    const std::string text = study_report(out).text;
    CHECK_THAT(text, Contains("a sweep of 4 runs\n") && Contains("deck          some.toml\n"));
    CHECK_THAT(text, Contains("finished      1\nstopped       1\nfailed        1\nnot begun     1\n"));
    CHECK_THAT(text, Contains("  temperature=1  finished\n  temperature=2  stopped at step 20 of 60\n"
                              "  temperature=3  failed                    error: blown up\n"
                              "  temperature=4  not begun\n"));
    CHECK_THAT(text, Catch::EndsWith("to go on: the command that began it\n"));

    CHECK(study_report(out, 80).text == text);
    std::ofstream(runs[2].log) << "error: " << std::string(30, 'x') << " was blown up\n";
    CHECK_THAT(study_report(out, 57).text,
               Contains("  temperature=3  failed\n  temperature=4  not begun\n  temperature=3: error: " +
                        std::string(30, 'x') + "\n    was blown up\n"));
    std::ofstream(runs[2].log) << "error: blown up\n";

    const Data json = study_report(out).data;
    CHECK(json["kind"] == "sweep");
    CHECK(json["deck"] == "some.toml");
    CHECK(json["running"] == false);
    CHECK(json["states"] == Data{{"finished", 1}, {"running", 0}, {"stopped", 1}, {"failed", 1}, {"not begun", 1}});
    REQUIRE(json["runs"].size() == 4);
    CHECK(json["runs"][1]["step"] == 20);
    CHECK(json["runs"][1]["total_steps"] == 60);
    CHECK(json["runs"][2]["words"] == "error: blown up");
    CHECK(json["runs"][2]["total_steps"] == 60);
    CHECK(json["runs"][3]["step"].is_null());
    CHECK(json["runs"][3]["total_steps"] == 60);
}

TEST_CASE("a run whose log a process holds is running, and a failed one tells its exit code") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    const SweepPlan plan{"some.toml", small_deck, {}, {{"system.temperature"}, {{"1"}, {"2"}}}};
    prepare_sweep(plan, out, false);
    const auto runs = sweep_runs(plan, out);
    std::ofstream(runs[0].log) << "error: of an earlier attempt\n";
    auto log = ClaimedFile::claim(runs[0].log);
    REQUIRE(log.has_value());
    std::ofstream(runs[1].log) << "killed\nended with exit code 137\n";
    const Data json = study_report(out).data;
    CHECK(json["runs"][0]["state"] == "running");
    CHECK(json["runs"][0]["words"] == "");
    CHECK(json["runs"][1]["state"] == "failed");
    CHECK(json["runs"][1]["words"] == "exit code 137 (signal 9): killed");
    log.reset();
    const Data free = study_report(out).data;
    CHECK(free["runs"][0]["state"] == "failed");
}

TEST_CASE("a run that has not begun has the steps of its point, and those that were added to its replica") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    const auto steps_in = [&](const SweepPlan& plan) {
        prepare_sweep(plan, out, true);
        std::vector<Index> steps;
        const Data found = study_report(out).data;
        for (const Data& run : found["runs"].items()) {
            steps.push_back(run["total_steps"].integer());
        }
        return steps;
    };
    const std::vector<std::string> settings{"stage.equilibrate.steps=7"};
    CHECK(steps_in({"some.toml", small_deck, settings, {{"stage.production.steps"}, {{"10"}, {"100"}}}}) ==
          std::vector<Index>{17, 107});
    CHECK(steps_in({"some.toml", small_deck, {}, {{"system.seed"}, {{"1"}, {"2"}}}, 2, 30}) ==
          std::vector<Index>{90, 90});
}

TEST_CASE("a reproduced table is a study, too, a run or an empty directory is none") {
    const TemporaryFolder folder;
    const fs::path out = folder / "";
    CHECK_FALSE(holds_study(out));
    fs::create_directories(out / "rows");
    std::ofstream(out / "rows" / "b.toml") << small_deck;
    std::ofstream(out / "rows" / "a.toml") << small_deck;
    REQUIRE(holds_study(out));
    CHECK_THAT(study_report(out).text,
               Contains("a reproduced table of 2 runs\n") && Contains("  a  not begun\n  b  not begun\n"));
    CHECK(study_report(out).data["kind"] == "reproduction");
    CHECK(study_report(out).data["runs"][1]["total_steps"] == 60);
    std::ofstream(out / "rows" / "b.toml") << "damaged";
    CHECK(study_report(out).data["runs"][1]["total_steps"] == 0);
    std::ofstream(out / "run.json") << "{}";
    CHECK_FALSE(holds_study(out));
}

TEST_CASE("a damaged record of a sweep is told") {
    const TemporaryFolder folder;
    std::ofstream(folder / "sweep.json") << "{";
    CHECK_THROWS_AS(study_report(folder / ""), DataError);
}
