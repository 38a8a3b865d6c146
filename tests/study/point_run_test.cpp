#include "ljmd/study/point_run.hpp"

#include "run/run_fixtures.hpp"

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
