#include "report/report_fixtures.hpp"
#include "report/run_charts.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("tables of analyses are drawn with their bands, from the run or from its folder analysis") {
    const TemporaryFolder folder;
    const std::filesystem::path directory = folder / "";
    std::filesystem::create_directory(directory / "analysis");
    overwrite(directory / "rdf.csv", "r,g,g_standard_error\n0.5,0,0\n1.0,2.5,0.1\n");
    overwrite(directory / "analysis/msd.csv", "time,msd,msd_standard_error\n0,0,0\n1,0.5,0.1\n");
    overwrite(directory / "vacf.csv", "time,vacf\n0,x\n");
    PageContent page{.kind = "run", .title = "", .source = ""};
    add_analyses(page, {directory, {}, {}, {}, "finished", "", {}});
    check_marks(page);
    CHECK(page.charts.size() == 2);
    CHECK(chart_called(page, "rdf-g").marks[0].type == "rule-y");
    CHECK(chart_called(page, "rdf-g").marks[1].type == "band");
    CHECK(table_called(page, "msd").file == "analysis/msd.csv");
    REQUIRE(page.warnings.size() == 2);  // the damaged table would be in two charts
    CHECK_THAT(page.warnings[0], Contains("vacf.csv"));
}

TEST_CASE("Bragg peaks are drawn beside the heights that displacements let expect") {
    const TemporaryFolder folder;
    overwrite(
        folder / "bragg.csv",
        "k,debye_waller_factor,debye_waller_factor_standard_error,debye_waller_gaussian\n6.8,0.762,0.001,0.7617\n");
    PageContent page{.kind = "run", .title = "", .source = ""};
    add_analyses(page, {folder / "", {}, {}, {}, "finished", "", {}});
    check_marks(page);
    CHECK(page.warnings.empty());
    CHECK(chart_called(page, "bragg-debye_waller_factor").y.scale == "log");
    CHECK(chart_called(page, "bragg-debye_waller_factor").marks[1].error == "debye_waller_factor_standard_error");
    CHECK(table_called(page, "bragg").rows == 1);
}

TEST_CASE("the time by phase is drawn if the record has it") {
    PageContent page{.kind = "run", .title = "", .source = ""};
    add_phases(page, {"", {{"seconds_per_phase", {{"force", 2.0}, {"list", 0.5}}}}, {}, {}, "", "", {}});
    check_marks(page);
    CHECK(values_of(table_called(page, "phases"), "phase")[1] == "list");
    PageContent none{.kind = "run", .title = "", .source = ""};
    add_phases(none, {"", Data::object(), {}, {}, "", "", {}});
    CHECK(none.charts.empty());
}
