#include "report/pages/study_pages.hpp"

#include "compare/recorded_comparison.hpp"
#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("checks are drawn in units of their tolerances, failed ones are marked") {
    const TemporaryFolder folder;
    CHECK_FALSE(holds_comparison(folder / ""));
    overwrite(folder / "compare-lammps.json",
              R"({"deck": "a.toml", "with": "lammps", "checks": [
                  {"name": "energy", "value": 1e-9, "tolerance": 1e-8, "passed": true},
                  {"name": "forces", "value": 2e-8, "tolerance": 1e-8, "passed": false},
                  {"name": "equal", "value": 0.0, "tolerance": 1e-8, "passed": true}], "passed": false,
                  "trajectory": {"divergence_rate": 2.0},
                  "averages": {"observables": {"pressure": {"ljmd": {"mean": 1.0, "standard_error": 0.1},
                                                            "peer": {"mean": 1.1, "standard_error": 0.2}, "sigmas": 0.4}}}})");
    overwrite(
        folder / "compare-lammps-trajectory.csv",
        "step,time,double - lammps,potential_energy_difference\n0,0,0,0\n10,1,1e-8,0\n20,2,7.389056e-8,0\n30,3,2,0\n");
    overwrite(folder / "compare-lammps-rdf.csv",
              "r,g_ljmd,g_ljmd_standard_error,g_peer,g_peer_standard_error\n1,2.5,0.03,2.4,0.04\n");
    REQUIRE(holds_comparison(folder / ""));
    const PageContent page = comparison_page(folder / "");
    check_marks(page);
    CHECK(page.warnings.empty());
    CHECK(page.title == "a.toml against lammps");
    CHECK(verdict_on(page.verdicts, "agreement").words == "1 of 3 checks failed.");
    const PageTable& checks = table_called(page, "checks");
    CHECK(values_of(checks, "ratio")[0].number() == Approx(0.1));
    CHECK(values_of(checks, "ratio")[2].is_null());
    CHECK(values_of(checks, "failed") == Data::List{false, true, false});
    // d(t) = d_0 exp(2 t) goes through both distances that grow.
    const Data::List& fit = values_of(table_called(page, "trajectory"), "fit");
    CHECK(fit[1].number() == Approx(1e-8));
    CHECK(fit[2].number() == Approx(7.389056e-8));
    const PageTable& rdf = table_called(page, "rdf");
    CHECK(values_of(rdf, "difference")[0].number() == Approx(0.1));
    CHECK(values_of(rdf, "difference_standard_error")[0].number() == Approx(0.05));
    CHECK(quantity_called(page.quantities, "pressure").reference == 1.1);
}

TEST_CASE("errors against a reference are drawn, damaged files are told") {
    const TemporaryFolder folder;
    overwrite(folder / "compare-gsl.json", R"({"deck": "b.toml", "with": "gsl", "checks": []})");
    overwrite(folder / "compare-gsl.csv", "step,time,position_error,energy_error\n0,0,0,0\n1,0.1,1e-6,1e-7\n");
    PageContent page = comparison_page(folder / "");
    check_marks(page);
    CHECK(chart_called(page, "errors").marks.size() == 2);
    CHECK(verdict_on(page.verdicts, "agreement").level == "unknown");
    overwrite(folder / "compare-gsl.csv", "step,time,position_error\n0,0\n");
    overwrite(folder / "compare-openmm.json", "{}");
    page = comparison_page(folder / "");
    REQUIRE(page.warnings.size() == 2);
    CHECK_THAT(page.warnings[0], Contains("compare-openmm.json is another comparison"));
    overwrite(folder / "compare-gsl.json", "[");
    CHECK_THROWS_AS(comparison_page(folder / ""), DataError);
}

TEST_CASE("a judgement of an engine has its diagnosis, what was not judged, and the trajectory of the engine") {
    const TemporaryFolder folder;
    overwrite(folder / "judge.json",
              R"({"deck": "a.toml", "with": "command:./engine {input} {output}", "peer": "mine", "atoms": 108,
                  "checks": [{"name": "virial", "value": 1.0, "tolerance": 1e-11, "passed": false}], "passed": false,
                  "averages": {"observables": {"pressure": {"ljmd": {"mean": 1.0, "standard_error": 0.1},
                                                            "peer": {"mean": 1.1, "standard_error": 0.2}, "sigmas": 0.4}}},
                  "trajectory": {"steps": [{"step": 0, "time": 0.0, "distance": 0.0, "force_difference": 1e-15},
                                           {"step": 10, "time": 0.04, "distance": 1e-12, "force_difference": null}]},
                  "diagnoses": ["virial: the sign is wrong"], "not_judged": ["volume: missing"], "warnings": ["a remark"]})");
    REQUIRE(holds_comparison(folder / ""));
    PageContent page = comparison_page(folder / "");
    check_marks(page);
    CHECK(page.title == "a.toml against mine");
    CHECK(page.warnings == std::vector<std::string>{"a remark"});
    CHECK(verdict_on(page.verdicts, "diagnosis").words == "Virial: the sign is wrong.");
    CHECK(verdict_on(page.verdicts, "diagnosis").level == "bad");
    CHECK(verdict_on(page.verdicts, "not judged").words == "Volume: missing.");
    CHECK(quantity_called(page.quantities, "pressure").reference_label == "mine");
    const PageTable& steps = table_called(page, "trajectory");
    CHECK(values_of(steps, "distance")[0].is_null());
    CHECK(values_of(steps, "distance")[1].number() == 1e-12);
    CHECK(values_of(steps, "force_difference")[1].is_null());
    CHECK(chart_called(page, "distance").y.scale == "log");
    overwrite(
        folder / "judge.json",
        R"({"deck": "a.toml", "peer": "mine", "checks": [{"name": "virial", "value": 1.0, "tolerance": 1e-11, "passed": false}],
                  "passed": false, "diagnoses": [], "not_judged": [], "warnings": [], "trajectory": {"steps": []}})");
    page = comparison_page(folder / "");
    CHECK(verdict_on(page.verdicts, "diagnosis").words == "No mistake that is known explains what failed.");
    CHECK(std::ranges::none_of(page.charts, [](const Chart& chart) { return chart.id == "distance"; }));
}
