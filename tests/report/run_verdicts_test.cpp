#include "ljmd/report/run_verdicts.hpp"

#include <cmath>

#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A report whose temperature is in equilibrium from this row on, with these means.
ThermoReport report_of(Index start, double independent, double mean, double mean_of_all) {
    ThermoReport report{1000, 0, 9990, 0.01, 10, {}};
    report.columns.push_back(
        {"temperature", {start, 5.0, independent, mean, 0.01}, 5.0, {mean_of_all, 0.01, independent, 1000, true}});
    return report;
}

Data results_of(const Data& observables, const Data& stage) {
    return {{"observables", observables}, {"stages", Data::list({stage})}};
}

std::vector<Verdict> verdicts_of(const Data& results) {
    return result_verdicts({"", {}, {}, results, "finished", "", {}});
}

}  // namespace

TEST_CASE("a run is in equilibrium if it does not matter where sampling begins") {
    CHECK(equilibrium_verdict(report_of(300, 100.0, 1.0, 1.015)).level == "good");
    CHECK(equilibrium_verdict(report_of(300, 100.0, 1.0, 1.025)).level == "doubt");
    CHECK(equilibrium_verdict(report_of(600, 100.0, 1.0, 1.025)).level == "bad");
    CHECK_THAT(equilibrium_verdict(report_of(300, 100.0, 1.0, 1.025)).words,
               Contains("first 30 %") && Contains("mean of temperature"));
    CHECK(equilibrium_verdict(report_of(0, 12.0, 1.0, 1.0)).level == "doubt");
    CHECK(equilibrium_verdict(report_of(0, 100.0, 1.0, 1.0), 0.05).level == "good");
    CHECK(equilibrium_verdict(report_of(0, 100.0, 1.0, 1.0), 0.3).level == "bad");
    CHECK_THAT(equilibrium_verdict(report_of(0, 100.0, 1.0, 1.0), 0.3).words, Contains("30 % of the crystal"));
    CHECK(equilibrium_verdict({1000, 0, 9990, 0.01, 10, {}}).level == "unknown");
}

TEST_CASE("energy is judged where it is conserved, by what the results say of its drift") {
    const Data kinetic = {{"kinetic_energy", {{"mean", 1.0}, {"standard_error", 0.01}, {"independent_samples", 50.0}}}};
    const Data stage = {
        {"name", "production"}, {"sampled", true}, {"energy_drift", 1e-5}, {"time_step", 0.01}, {"steps", 10'000}};
    const Verdict good = verdict_on(verdicts_of(results_of(kinetic, stage)), "energy");
    CHECK(good.level == "good");
    CHECK_THAT(good.words,
               Contains("1.0e-05 epsilon per tau") && Contains("1.0e-03 epsilon in 100 tau") && Contains("0.1 %"));
    Data drifting = stage;
    drifting["energy_drift_remark"] = "too much";
    CHECK(verdict_on(verdicts_of(results_of(kinetic, drifting)), "energy").level == "bad");
    Data heated = stage;
    heated["energy_drift"] = nullptr;
    CHECK(verdict_on(verdicts_of(results_of(kinetic, heated)), "energy").level == "unknown");
}

TEST_CASE("the verdict on error bars names the quantities whose error bars are guesses") {
    const Data sure = {
        {"mean", 1.0}, {"standard_error", 0.1}, {"independent_samples", 42.0}, {"error_is_converged", true}};
    Data unsure = sure;
    unsure["error_is_converged"] = false;
    const Data none = Data::object();
    CHECK_THAT(verdict_on(verdicts_of(results_of({{"pressure", sure}}, none)), "error bars").words,
               Contains("reliable") && Contains("42 independent samples (of pressure)"));
    const Verdict guess =
        verdict_on(verdicts_of(results_of({{"pressure", sure}, {"diffusion", unsure}}, none)), "error bars");
    CHECK(guess.level == "doubt");
    CHECK_THAT(guess.words, Contains("of diffusion are guesses"));
    CHECK(verdict_on(verdicts_of(results_of({{"pressure_xx", unsure}}, none)), "error bars").level == "unknown");
}

TEST_CASE("temperature and time step are judged where there is something to judge") {
    Data results = results_of({{"temperature", {{"mean", 1.05}, {"standard_error", 0.01}}}},
                              {{"name", "p"}, {"time_step_error", 0.02}, {"time_step_remark", "2 % apart"}});
    CHECK(verdict_on(verdicts_of(results), "time step").level == "bad");
    results["asked_temperature"] = 1.0;
    CHECK(verdict_on(verdicts_of(results), "temperature").level == "doubt");
    results["asked_temperature"] = 1.03;
    CHECK(verdict_on(verdicts_of(results), "temperature").level == "good");
    CHECK(verdicts_of(Data()).size() == 2);
}

TEST_CASE("an equation of state is agreed with within three errors of both") {
    Quantity pressure{.name = "pressure", .value = 1.0, .error = 0.03, .reference = 1.14, .reference_error = 0.04};
    CHECK(reference_verdict({pressure}, "thol2016").level == "good");
    CHECK_THAT(reference_verdict({pressure}, "thol2016").words,
               Contains("pressure by -0.") && Contains("(-2.8 errors)"));
    pressure.reference = 1.16;
    CHECK(reference_verdict({pressure}, "thol2016").level == "doubt");
    CHECK_THAT(reference_verdict({pressure}, "thol2016").words, Contains("accuracies of the equation"));
    CHECK(reference_verdict({}, "there is none").level == "unknown");
}
