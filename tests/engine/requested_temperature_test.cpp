#include "ljmd/detail/engine/requested_temperature.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/at_temperature.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string truncation = "cutoff = 2.0\ntruncation = \"force-shifted\"";
const std::string rescaling = "thermostat = { type = \"rescale\", every = 5 }";
const std::string sampled = "sample = true\n";

FluidSpec spec_of(const Replacements& replacements, const std::vector<std::string>& settings = {}) {
    return fluid_spec(DeckFolder(changed(small_deck, replacements)).load(settings));
}

FluidSpec full_fluid(const std::vector<std::string>& settings = {}) {
    return spec_of({{truncation, "cutoff = 2.5\ntruncation = \"cut\"\ntail = true"}}, settings);
}

std::optional<Estimate> measured(double mean, double error) {
    return Estimate{mean, error, 100.0, 1000, true};
}

/// Averages of a run whose temperature swings about a mean, at density 0.8; pressure and energy swing with it.
RunAverages averages_at(double temperature, double swing = 0.01) {
    RunAverages averages(108, Ensemble::constant_energy);
    for (int k = 0; k < 400; ++k) {
        Thermodynamics row;
        const double x = swing * std::sin(2.4 * k);
        row.temperature = temperature + x;
        row.potential_energy = -5.5 - 1.5 * x;
        row.pressure = 0.9 + 7.0 * x;
        row.density = 0.8;
        averages.add(row);
    }
    return averages;
}

}  // namespace

TEST_CASE("a deck asks for the temperature that is held where it samples, or was last before") {
    CHECK(requested_temperature(spec_of({})) == 1.0);
    CHECK(requested_temperature(spec_of({}, {"stage.equilibrate.temperature=0.7"})) == 0.7);
    CHECK(requested_temperature(spec_of({{rescaling + "\n", ""}})) == 1.0);
    CHECK(requested_temperature(
              spec_of({{sampled, sampled + "thermostat = { type = \"langevin\" }\ntemperature = 0.9\n"}})) == 0.9);
    // What comes after the sampled stage, or has no steps, does not count.
    CHECK(requested_temperature(spec_of({}, {"stage.equilibrate.temperature=0.7", "stage.equilibrate.steps=0"})) ==
          1.0);
    const std::string later =
        "[[stage]]\nname = \"later\"\ntime_step = 0.004\nsteps = 10\ntemperature = 2.0\n" + rescaling;
    CHECK(requested_temperature(spec_of({{sampled, sampled + later}})) == 1.0);
    CHECK_FALSE(requested_temperature(spec_of({{sampled, ""}})));
    // Two sampled stages that are asked for two temperatures.
    CHECK_FALSE(requested_temperature(spec_of({{sampled, sampled + later + "\n" + sampled}})));
    CHECK(requested_temperature(
              spec_of({{sampled, sampled + later + "\n" + sampled}}, {"stage.later.temperature=1.0"})) == 1.0);
}

TEST_CASE("a temperature that is off by more than three errors is remarked on, with what is asked and what is found") {
    const FluidSpec spec = spec_of({});
    CHECK(temperature_remark(spec, measured(0.9701, 0.01)).empty());
    CHECK(temperature_remark(spec, measured(1.0299, 0.01)).empty());
    CHECK_THAT(temperature_remark(spec, measured(0.9699, 0.01)),
               Contains("asked 1, found 0.9699: at constant energy the temperature is a result"));
    CHECK_THAT(temperature_remark(spec, measured(1.0301, 0.01)), Contains("asked 1, found 1.0301"));
    const FluidSpec held = spec_of({{sampled, sampled + "thermostat = { type = \"langevin\" }\n"}});
    CHECK_THAT(temperature_remark(held, measured(0.9, 0.01)), Contains("the thermostat has not brought it there"));
    CHECK_THAT(temperature_remark(fluid_spec(DeckFolder(small_deck + argon_table).load()), measured(0.9, 0.01)),
               Contains("asked 1 (119.8 K), found 0.9 (107.82 K)"));
    // Nothing is known of a temperature without an error, or without a value; what is held exactly has none.
    CHECK(temperature_remark(spec, measured(0.5, std::nan(""))).empty());
    CHECK(temperature_remark(spec, std::nullopt).empty());
    CHECK(temperature_remark(spec, measured(1.0 + 1e-15, 0.0)).empty());
    CHECK_FALSE(temperature_remark(spec, measured(0.5, 0.0)).empty());
}

TEST_CASE("a fluid has the equation of state of its own truncation, or none") {
    const auto name = [](const std::string& potential) {
        const auto equation = equation_of_fluid(spec_of({{truncation, potential}, {"cells = 3", "cells = 5"}}));
        return equation ? equation->name : "";
    };
    CHECK(name("cutoff = 2.5\ntruncation = \"cut\"\ntail = true") == "thol2016");
    CHECK(name("cutoff = 3.5\ntruncation = \"cut\"\ntail = true") == "thol2016");
    CHECK(name("cutoff = 2.4\ntruncation = \"cut\"\ntail = true").empty());
    CHECK(name("cutoff = 2.5\ntruncation = \"cut\"\ntail = false").empty());
    CHECK(name("cutoff = 2.5\ntruncation = \"shifted\"") == "thol2015");
    CHECK(name("cutoff = 2.6\ntruncation = \"shifted\"").empty());
    CHECK(name("cutoff = 2.5\ntruncation = \"force-shifted\"").empty());
    CHECK(name("cutoff = 2.5\ntruncation = \"switched\"\nswitch_start = 2.2\ntail = true").empty());
}

TEST_CASE("what was measured beside the temperature that was asked is brought there, and only then") {
    const FluidSpec spec = full_fluid();
    const RunAverages averages = averages_at(0.96);
    const auto there = at_requested_temperature(spec, 0.8, averages);
    REQUIRE(there);
    CHECK(there->temperature == 1.0);
    CHECK(there->equation == "thol2016");
    REQUIRE(there->observables.size() == 3);
    const AtTemperature expected =
        at_temperature(equation_of_state("thol2016"), 0.8, 1.0, averages.means_of_state(),
                       [&](double value, const Vec3& gradient) { return averages.estimate(value, gradient); });
    CHECK(there->observables[0].name == "potential_energy");
    CHECK(there->observables[0].estimate->mean == expected.potential_energy.mean);
    CHECK(there->observables[1].name == "pressure");
    CHECK(there->observables[1].estimate->mean == expected.pressure.mean);
    CHECK(there->observables[1].estimate->standard_error == expected.pressure.standard_error);
    CHECK(there->observables[2].name == "compressibility_factor");
    CHECK(there->observables[2].estimate->mean == expected.compressibility_factor.mean);

    CHECK_FALSE(at_requested_temperature(spec, 0.8, averages_at(1.0)));   // found
    CHECK_FALSE(at_requested_temperature(spec, 0.8, averages_at(0.89)));  // too far
    CHECK_FALSE(at_requested_temperature(spec, 0.6, averages));           // liquid and vapour
    CHECK_FALSE(at_requested_temperature(spec_of({}), 0.8, averages));    // no equation
    CHECK_FALSE(at_requested_temperature(full_fluid({"stage.production.thermostat={ type = \"langevin\" }"}), 0.8,
                                         averages));  // held
}

TEST_CASE("runs at constant energy, brought to one temperature, scatter as their errors say") {
    // Seeds end at other energies: p differs from seed to seed by many of its errors, p at T = 1 does not.
    constexpr int seeds = 16;
    double plain = 0.0;
    double brought = 0.0;
    std::vector<std::pair<Estimate, Estimate>> found;
    for (int seed = 1; seed <= seeds; ++seed) {
        const DeckFolder folder(changed(small_deck, {{truncation, "cutoff = 2.5\ntruncation = \"cut\"\ntail = true"},
                                                     {"density = 0.8", "density = 0.75"}}));
        Deck deck = folder.load(
            {fmt::format("system.seed={}", seed), "stage.equilibrate.steps=2000", "stage.production.steps=10000"});
        prepare_directory(deck.directory);
        FluidSystem simulation = simulation_of(deck);
        Recorder listener;
        const RunResult result = run_plan(deck, simulation, listener);
        const auto p = std::ranges::find(result.averages, "pressure", &ObservableAverage::name)->estimate;
        if (result.at_requested) {
            found.emplace_back(*p, *result.at_requested->observables[1].estimate);
        }
    }
    REQUIRE(found.size() >= seeds / 2);
    double mean_plain = 0.0;
    double mean_brought = 0.0;
    const auto count = static_cast<double>(found.size());
    for (const auto& [p, there] : found) {
        mean_plain += p.mean / count;
        mean_brought += there.mean / count;
    }
    for (const auto& [p, there] : found) {
        plain += std::pow((p.mean - mean_plain) / p.standard_error, 2) / (count - 1.0);
        brought += std::pow((there.mean - mean_brought) / there.standard_error, 2) / (count - 1.0);
    }
    CAPTURE(found.size(), plain, brought, mean_plain, mean_brought);
    CHECK(plain > 9.0);
    CHECK(brought < 4.0);
    CHECK(brought > 0.1);
}
