#include "study/point_run.hpp"

#include "io/files/input_file.hpp"
#include "run/run_fixtures.hpp"
#include "study/study_report.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

SweepPlan two_points() {
    return {"some.toml", small_deck, {}, {{"system.temperature"}, {{"1"}, {"2"}}}};
}

/// A run of a point, begun and stopped after this step, or run to its end.
void leave_run(const ChildRun& run, Index last_step) {
    Diagnostics diagnostics;
    auto deck = load_deck_text("deck.toml", run.source, run.settings, false, diagnostics);
    REQUIRE(deck.has_value());
    deck->directory = run.directory;
    run_until(*deck, last_step);
}

}  // namespace

TEST_CASE("a point has its results when its run is at its end, whoever ran it") {
    const TemporaryFolder folder;
    prepare_sweep(two_points(), folder / "", false);
    std::vector<PointRun> runs = point_runs(two_points(), folder / "");
    REQUIRE(runs.size() == 2);
    leave_run(runs[0].run(), 60);
    leave_run(runs[1].run(), 30);
    CHECK_FALSE(runs[0].begin().has_value());
    CHECK(runs[0].failure().empty());
    CHECK(runs[0].point().found.size() > 3);
    CHECK(runs[0].point().values == std::vector<std::string>{"1"});
    const auto job = runs[1].begin();
    REQUIRE(job.has_value());
    CHECK(job->arguments.front() == "resume");
    CHECK_FALSE(runs[1].after(137).has_value());
    CHECK_THAT(runs[1].failure(), Contains("temperature=2: exit code 137 (signal 9): "));
}

TEST_CASE("a point whose record cannot be used has failed in whatever way, and the others go on") {
    const TemporaryFolder folder;
    prepare_sweep(two_points(), folder / "", false);
    std::vector<PointRun> runs = point_runs(two_points(), folder / "");
    leave_run(runs[0].run(), 60);
    leave_run(runs[1].run(), 60);
    const fs::path record = runs[0].run().directory / "run.json";
    const std::string good = read_input(record);
    const auto with = [&](const std::string& old, const std::string& text) {
        std::string changed = good;
        const std::size_t at = changed.find(old);
        REQUIRE(at != std::string::npos);
        return changed.replace(at, old.size(), text);
    };
    for (const std::string& text :
         {std::string(), std::string("null"), std::string("[[["), std::string(10, '\0'), with("fcc", "xcc"),
          with("\"threads\": 1", "\"threads\": 0"), with("\"program\": \"ljmd\"", "\"program\": \"another\""),
          with("lattice", "latice"), good.substr(0, good.size() / 2)}) {
        std::ofstream(record) << text;
        CAPTURE(text);
        for (PointRun& run : point_runs(two_points(), folder / "")) {
            CHECK_FALSE(run.begin().has_value());
            const bool damaged = run.run().directory == runs[0].run().directory;
            CHECK(run.failure().starts_with("temperature=1: ") == damaged);
            CHECK(run.failure().empty() == !damaged);
            CHECK(run.point().failure == run.failure());
            CHECK(run.point().found.empty() == damaged);
        }
        const Document state = study_report(folder / "");
        CHECK(state.data["runs"][0]["state"] == "failed");
        CHECK(state.data["runs"][1]["state"] == "finished");
        CHECK_NOTHROW(prepare_sweep(two_points(), folder / "", false));
    }
}

TEST_CASE("a point with damaged files has failed, and the others have not") {
    const TemporaryFolder folder;
    prepare_sweep(two_points(), folder / "", false);
    std::vector<PointRun> runs = point_runs(two_points(), folder / "");
    leave_run(runs[0].run(), 60);
    leave_run(runs[1].run(), 60);
    std::ofstream(runs[0].run().directory / "run.json") << "{";
    std::ofstream(runs[1].run().directory / "results.json") << "{";
    for (PointRun& run : runs) {
        CHECK_FALSE(run.begin().has_value());
        CHECK_THAT(run.failure(), Contains(".json is not the re"));
        CHECK(run.point().found.empty());
    }
}
