#include <cmath>

#include "report/pages/study_pages.hpp"
#include "report/report_fixtures.hpp"
#include "study/sweep_record.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// Run these points of a sweep.
void run_points(const SweepPlan& plan, const fs::path& directory, std::size_t count) {
    prepare_sweep(plan, directory, false);
    const std::vector<ChildRun> runs = sweep_runs(plan, directory);
    for (std::size_t k = 0; k < count; ++k) {
        Diagnostics diagnostics;
        auto deck = load_deck_text("deck.toml", runs[k].source, runs[k].settings, true, diagnostics);
        REQUIRE(deck.has_value());
        deck->directory = runs[k].directory;
        run_whole(*deck);
    }
}

}  // namespace

TEST_CASE("a sweep of temperatures is drawn against those that were measured, in their order") {
    const TemporaryFolder folder;
    const SweepPlan plan{"some.toml", small_deck, {}, {{"system.temperature"}, {{"3"}, {"1"}, {"2"}}}};
    run_points(plan, folder / "", 3);
    const PageContent page = sweep_page(folder / "");
    check_marks(page);
    CHECK(page.state == "finished");
    CHECK(page.points.size() == 3);
    const PageTable& table = table_called(page, "points");
    CHECK(table.lead);
    CHECK(values_of(table, "set_temperature") == Data::List{1, 2, 3});
    CHECK(chart_called(page, "pressure").marks.back().x == "temperature");
    CHECK(chart_called(page, "pressure").lead);
}

TEST_CASE("two keys make series and a map, a point that is missing or has failed is told") {
    const TemporaryFolder folder;
    std::vector<std::vector<std::string>> values;
    for (const char* density : {"0.6", "0.7", "0.8"}) {
        for (const char* temperature : {"1", "1.5", "2"}) {
            values.push_back({density, temperature});
        }
    }
    const SweepPlan plan{"some.toml",
                         small_deck,
                         {"potential.truncation=cut", "potential.tail=true", "potential.cutoff=2.5"},
                         {{"system.density", "system.temperature"}, values}};
    run_points(plan, folder / "", 8);
    overwrite(sweep_runs(plan, folder / "")[8].log, "error: blown up\n");
    const PageContent page = sweep_page(folder / "");
    check_marks(page);
    CHECK(page.state == "stopped");
    REQUIRE(page.warnings.size() == 1);
    CHECK_THAT(page.warnings[0], Contains("blown up"));
    CHECK(values_of(table_called(page, "points"), "series").size() == 8);
    CHECK(chart_called(page, "pressure-map").marks[0].type == "cells");
    CHECK(chart_called(page, "pressure").marks[0].label == "thol2016");
    CHECK(chart_called(page, "pressure").marks[0].y == "pressure_reference");
}

TEST_CASE("a sweep that has hardly begun has a page without charts, a key that is no number makes categories") {
    const TemporaryFolder folder;
    const SweepPlan plan{"some.toml", small_deck, {}, {{"potential.truncation"}, {{"cut"}, {"shifted"}}}};
    run_points(plan, folder / "", 0);
    CHECK(sweep_page(folder / "").charts.empty());
    CHECK_THROWS_AS(sweep_page(folder / "points"), DataError);
    const SweepPlan names{"some.toml", small_deck, {}, {{"potential.truncation"}, {{"shifted"}, {"force-shifted"}}}};
    const TemporaryFolder other;
    run_points(names, other / "", 2);
    CHECK(chart_called(sweep_page(other / ""), "potential_energy").x.scale == "category");
}
