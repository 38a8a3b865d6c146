#include "report/run_verdicts.hpp"

#include <cmath>

#include "report/report_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A report of 1000 rows about temperature and pressure.
ThermoReport report_of(const Equilibration& temperature, const Equilibration& pressure) {
    ThermoReport report{1000, 0, 9990, 0.01, {}};
    const auto add = [&](const char* name, const Equilibration& found, bool conserved) {
        const ObservableAverage average{name, "", "", Estimate{1.0, 0.01, 200.0, 1000, true}};
        report.columns.push_back({average, average, found, conserved, 5.0});
    };
    add("temperature", temperature, false);
    add("total_energy", {std::nullopt, false, std::nan("")}, true);
    add("pressure", pressure, false);
    return report;
}

Data results_of(const Data& observables, const Data& stage) {
    return {{"observables", observables}, {"stages", Data::list({stage})}};
}

std::vector<Verdict> verdicts_of(const Data& results) {
    return result_verdicts({"", {}, {}, results, "finished", "", {}});
}

}  // namespace

TEST_CASE("a run is in equilibrium if nothing in it changes, and if it is long enough to tell") {
    const Equilibration settled{0, false, 5.0};
    const Equilibration late{300, false, 5.0};
    const Equilibration changing{std::nullopt, true, 5.0};
    const Equilibration unknown{std::nullopt, false, 100.0};
    const Verdict good = equilibrium_verdict(report_of(settled, settled));
    CHECK(good.level == "good");
    CHECK_THAT(good.words, Contains("200 independent samples"));
    const Verdict doubt = equilibrium_verdict(report_of(settled, late));
    CHECK(doubt.level == "doubt");
    CHECK_THAT(doubt.words, Contains("Not in equilibrium when sampling began") && Contains("first 30 %"));
    CHECK(equilibrium_verdict(report_of(unknown, late)).words == doubt.words);
    const Verdict bad = equilibrium_verdict(report_of(late, changing));
    CHECK(bad.level == "bad");
    CHECK_THAT(bad.words, Contains("pressure still changed in the second half"));
    const Verdict brief = equilibrium_verdict(report_of(unknown, unknown));
    CHECK(brief.level == "doubt");
    CHECK_THAT(brief.words, Contains("Too short to judge equilibrium: 10 independent samples"));
    CHECK(equilibrium_verdict(report_of(settled, settled), 0.3).level == "bad");
    CHECK_THAT(equilibrium_verdict(report_of(settled, settled), 0.3).words, Contains("30 % of the crystal"));
    CHECK(equilibrium_verdict({1000, 0, 9990, 0.01, {}}).level == "unknown");
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
    CHECK_THAT(reference_verdict({pressure}, "thol2016").words, Contains("Not within three errors of"));
    CHECK(reference_verdict({}, "there is none").level == "unknown");
}
