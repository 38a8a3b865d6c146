#include "judge/run_judgement.hpp"
#include "judge/failed_checks.hpp"
#include "judge/own_run.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// Correlated numbers of this mean and deviation, the same everywhere but for rounding: an autoregressive series.
std::vector<double> series(double mean, double deviation, unsigned seed, int count = 20000, double memory = 0.8) {
    std::mt19937_64 source(seed);
    const auto uniform = [&] { return static_cast<double>(source() >> 11U) * 0x1p-53; };
    std::vector<double> x;
    double last = 0.0;
    for (int k = 0; k < count; ++k) {
        const double normal =
            std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * 3.141592653589793 * uniform());
        last = memory * last + std::sqrt(1.0 - memory * memory) * normal;
        x.push_back(mean + deviation * last);
    }
    return x;
}

constexpr double freedom = 2997.0;  // so many that a gamma distribution is normal as far as these tests see

RunConditions canonical() {
    return {.atoms = 1000, .time_step = 0.004, .temperature = 1.5, .freedom = 2997, .our_freedom = 2997};
}

RunSamples samples(unsigned seed, double temperature = 1.5, double spread = 1.0) {
    return {.potential_energy = series(-5000.0, 30.0, seed),
            .kinetic_energy = series(0.5 * freedom * temperature, spread * std::sqrt(0.5 * freedom) * 1.5, seed + 1),
            .pressure = series(0.7, 0.1, seed + 2),
            .volume = series(1200.0, 20.0, seed + 3)};
}

}  // namespace

TEST_CASE("a run of the same distribution passes, correlations counted") {
    RunConditions conditions = canonical();
    conditions.pressure = 0.7;
    const RunJudgement judged = judge_run(conditions, samples(1), samples(100));
    CHECK(test::failed_checks(judged).empty());
    CHECK(judged.checks.size() == 10);
    CHECK(judged.means.size() == 5);
    CHECK(judged.diagnoses.empty());
    CHECK(judged.not_judged.empty());
}

TEST_CASE("another mean of any quantity fails") {
    for (auto member : {&RunSamples::potential_energy, &RunSamples::pressure}) {
        RunSamples theirs = samples(100);
        for (double& x : theirs.*member) {
            x *= 1.06;
        }
        CHECK(test::failed_checks(judge_run(canonical(), samples(1), theirs)).size() == 1);
    }
}

TEST_CASE("a thermostat is judged by the distribution of the kinetic energy") {
    const auto judged = [](const RunSamples& theirs) { return judge_run(canonical(), samples(1), theirs); };
    const auto others = judged(samples(100, 1.5 * 3000.0 / 2997.0));
    CHECK(others.diagnoses.empty());  // a part in a thousand is what a time step may do
    const auto hot = judged(samples(100, 1.53));
    CHECK_THAT(hot.diagnoses.at(0), StartsWith("other temperature") && Contains("T = 1.53"));
    const auto quiet = judged(samples(100, 1.5, 0.7));
    CHECK_THAT(quiet.diagnoses.at(0), StartsWith("too little fluctuation: the variance of the kinetic energy is 0.4"));
    CHECK(test::failed_checks(quiet).size() == 2);  // variance, and the whole distribution
    CHECK(judged({}).not_judged.size() == 4);
}

TEST_CASE("an engine at constant energy is called so, where a temperature is held") {
    RunSamples theirs = samples(100, 1.5, 0.5);
    for (std::size_t k = 0; k < theirs.kinetic_energy.size(); ++k) {
        theirs.potential_energy[k] = -3000.0 - theirs.kinetic_energy[k];
    }
    const auto said = judge_run(canonical(), samples(1), theirs).diagnoses;
    REQUIRE(said.size() == 1);
    CHECK_THAT(said[0],
               StartsWith("no thermostat: the total energy is conserved, where the deck holds") && Contains("at 1.5"));
}

TEST_CASE("3 N degrees of freedom are told from 3 N - 3, and the other way") {
    RunConditions few = canonical();
    few.atoms = 10;
    few.freedom = few.our_freedom = 27;
    RunSamples theirs;
    theirs.kinetic_energy = series(0.5 * 30.0 * 1.5, std::sqrt(0.5 * 27.0) * 1.5, 3);
    const auto found = judge_run(few, theirs, theirs);
    CHECK_THAT(found.diagnoses.at(0), StartsWith("3N against 3N-3: the mean kinetic energy is 30 T/2, not 27 T/2") &&
                                          Contains("state degrees_of_freedom = 30 in point.json"));
    few.freedom = 30;
    theirs.kinetic_energy = series(0.5 * 27.0 * 1.5, std::sqrt(0.5 * 30.0) * 1.5, 3);
    CHECK_THAT(judge_run(few, theirs, theirs).diagnoses.at(0), Contains("is 27 T/2, not 30 T/2"));
}

TEST_CASE("a barostat is judged by the fluctuation of the volume") {
    RunConditions conditions = canonical();
    conditions.pressure = 0.7;
    RunSamples theirs = samples(100);
    theirs.volume = series(1200.0, 10.0, 103);
    const RunJudgement judged = judge_run(conditions, samples(1), theirs);
    CHECK_THAT(judged.diagnoses.at(0), StartsWith("too little fluctuation: the variance of the volume is 0.2"));
    theirs.volume = series(1200.0, 40.0, 103);
    CHECK(test::failed_checks(judge_run(conditions, samples(1), theirs)) ==
          std::vector<std::string>{"variance of volume, standard errors apart"});
}

TEST_CASE("a short run is not judged, and said to be short") {
    RunSamples theirs;
    theirs.potential_energy = series(-5000.0, 30.0, 100, 12);
    const RunJudgement judged =
        judge_run({.atoms = 1000, .time_step = 0.004, .freedom = 2997, .our_freedom = 2997}, samples(1), theirs);
    CHECK(judged.checks.empty());
    CHECK_THAT(judged.not_judged.at(1), StartsWith("mean potential_energy: the run of the engine is too short"));
}

TEST_CASE("limits are exceeded once in ten thousand times, and are wider where errors are estimates") {
    CHECK(limit_of_errors({{1.0, 1e9}}) == Approx(3.8906).epsilon(1e-4));
    CHECK(limit_of_errors({{1.0, 12.0}}) == Approx(5.6945).epsilon(1e-4));
    CHECK(limit_of_errors({{1.0, 15.0}, {1.0, 15.0}}) == Approx(4.4824).epsilon(1e-4));
    CHECK(limit_of_errors({{1.0, 15.0}, {0.0, 1.0}}) == Approx(5.2391).epsilon(1e-4));
}

namespace {

constexpr Index atoms_of_walk = 100;

/// A run at constant energy whose total energy walks by steps of this deviation, or drifts.
RunSamples conserved(unsigned seed, double walk, double drift = 0.0, double noise = 0.01) {
    const int count = 4096;
    const std::vector<double> kinetic = series(150.0, 8.0, seed, count, 0.9);
    const std::vector<double> steps = series(0.0, walk, seed + 1, count, 0.0);
    const std::vector<double> noises = series(0.0, noise, seed + 2, count, 0.5);
    RunSamples made;
    double walked = 0.0;
    for (std::size_t k = 0; k < kinetic.size(); ++k) {
        walked += steps[k] + drift / count;
        const double part = 0.57 * walked;  // of the energy that is kinetic
        made.kinetic_energy.push_back(kinetic[k] + part);
        made.potential_energy.push_back(-450.0 - (kinetic[k] - 150.0) + walked - part + noises[k]);
        made.pressure.push_back(0.5 + 0.01 * (kinetic[k] - 150.0));
        made.volume.push_back(120.0);
    }
    return made;
}

RunConditions constant_energy() {
    return {.atoms = atoms_of_walk, .time_step = 0.004, .freedom = 297, .our_freedom = 297, .same_motion = true};
}

}  // namespace

TEST_CASE("rows of the same steps are compared") {
    RunSamples ours{
        .potential_energy = {5, 10, 15, 20}, .kinetic_energy = {5, 10, 15, 20}, .pressure = {}, .volume = {}};
    RunSamples theirs{.potential_energy = {}, .kinetic_energy = {3, 10, 20, 30}, .pressure = {}, .volume = {}};
    keep_common_rows(ours, 5, theirs, {0, 3, 10, 20, 30});
    CHECK(ours.potential_energy == std::vector<double>{10, 20});
    CHECK(ours.kinetic_energy == std::vector<double>{10, 20});
    CHECK(theirs.kinetic_energy == std::vector<double>{10, 20});
    CHECK(theirs.potential_energy.empty());
}

TEST_CASE("the walk of our own energy is in the errors of means, and never that of the engine") {
    const RunSamples steady = conserved(1, 0.0);
    const RunSamples walking = conserved(10, 0.5);
    CHECK(test::failed_checks(judge_run(constant_energy(), steady, conserved(20, 0.0))).empty());
    CHECK(test::failed_checks(judge_run(constant_energy(), walking, conserved(30, 0.5))).empty());
    const auto failures = test::failed_checks(judge_run(constant_energy(), steady, conserved(30, 0.5)));
    CHECK(std::ranges::find(failures, "mean of the total energy, standard errors apart") != failures.end());
    CHECK(std::ranges::find(failures, "drift of the total energy, standard errors apart") != failures.end());
}

TEST_CASE("an engine whose energy drifts, or is not of one time, fails") {
    const RunSamples ours = conserved(10, 0.02);
    const auto drifting = test::failed_checks(judge_run(constant_energy(), ours, conserved(20, 0.02, 60.0)));
    CHECK(std::ranges::find(drifting, "drift of the total energy, standard errors apart") != drifting.end());
    CHECK(std::ranges::find(drifting, "mean temperature, standard errors apart") != drifting.end());
    RunSamples late = conserved(20, 0.02);
    for (std::size_t k = late.potential_energy.size() - 1; k > 0; --k) {
        late.potential_energy[k] = late.potential_energy[k - 1];
    }
    CHECK(test::failed_checks(judge_run(constant_energy(), ours, late)) ==
          std::vector<std::string>{"spread of the total energy from row to row, over that of ljmd"});
    RunSamples shifted = conserved(20, 0.02);
    for (double& u : shifted.potential_energy) {
        u += 10.0;
    }
    const auto off = test::failed_checks(judge_run(constant_energy(), ours, shifted));
    CHECK(std::ranges::find(off, "mean of the total energy, standard errors apart") != off.end());
}

TEST_CASE("distances of a gamma distribution see its shape") {
    // Waiting times of two events: gamma of shape 2.
    std::mt19937_64 source(5);
    const auto uniform = [&] { return static_cast<double>((source() >> 11U) + 1) * 0x1p-53; };
    std::vector<double> x;
    x.reserve(4000);
    for (int k = 0; k < 4000; ++k) {
        x.push_back(-std::log(uniform()) - std::log(uniform()));
    }
    CHECK(gamma_distance(x, 2.0, 1.0) < 1.5);
    CHECK(gamma_distance(x, 2.5, 1.0) > 2.0);
    CHECK(gamma_distance(x, 2.5, 8.0) < gamma_distance(x, 2.5, 1.0));
}
