#include "report/report.hpp"

#include "ljmd/core/errors.hpp"
#include "report/report_fixtures.hpp"
#include "study/sweep_record.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

TEST_CASE("a directory is reported on by what it holds") {
    const DeckFolder fluid;
    run_whole(fluid.load());
    CHECK(report_on(fluid / "out").kind == "run");
    const DeckFolder stars(stars_deck);
    run_whole(stars.load());
    CHECK(report_on(stars / "out").kind == "few-body");

    const TemporaryFolder folder;
    prepare_sweep({"some.toml", small_deck, {}, {{"system.temperature"}, {{"1"}}}}, folder / "", false);
    CHECK(report_on(folder / "").kind == "sweep");
    const TemporaryFolder table;
    fs::create_directories(table / "rows");
    CHECK(report_on(table / "").kind == "reproduction");
    const TemporaryFolder compared;
    overwrite(compared / "compare-gsl.json", "{\"checks\": []}");
    CHECK(report_on(compared / "").kind == "comparison");

    const PageContent set = report_on(std::vector<fs::path>{fluid / "out", stars / "out"});
    CHECK(set.kind == "set");
    CHECK(set.members.size() == 2);
    CHECK(report_on(std::vector<fs::path>{stars / "out"}).kind == "few-body");
}

TEST_CASE("what is no directory of ljmd is refused") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(report_on(folder / ""), Contains("has no run.json"));
    CHECK_THROWS_WITH(report_on(folder / "nowhere"), Contains("is no directory"));
    CHECK_THROWS_AS(report_on(std::vector<fs::path>{}), InputError);
}
