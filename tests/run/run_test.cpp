#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"
#include "run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A deck that was run in its folder, and what came of it.
struct Finished {
    explicit Finished(const std::string& text, const std::vector<std::string>& settings = {})
        : folder(text), deck(folder.load(settings)), simulation(simulation_of(deck)) {
        prepare_directory(deck.directory);
        result = run_plan(deck, simulation, listener);
    }

    [[nodiscard]] std::string file(const std::string& name) const { return content_of(deck.directory / name); }

    DeckFolder folder;
    Deck deck;
    FluidSystem simulation;
    Recorder listener;
    RunResult result{};
};

const ObservableAverage& average(const RunResult& result, const std::string& name) {
    const auto found = std::find_if(result.averages.begin(), result.averages.end(),
                                    [&](const ObservableAverage& a) { return a.name == name; });
    REQUIRE(found != result.averages.end());
    return *found;
}

bool warned(const RunResult& result, const std::string& part) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("all stages are run, step after step, and every tenth step is in thermo.csv") {
    const Finished run(small_deck);
    CHECK(run.listener.stages == std::vector<std::string>{"equilibrate", "production"});
    REQUIRE(run.listener.steps.size() == 60);
    for (Index n = 1; n <= 60; ++n) {
        CHECK(run.listener.steps[static_cast<std::size_t>(n - 1)] == n);
    }
    CHECK(run.simulation.state.step == 60);
    CHECK(run.simulation.state.time == Approx(0.24).epsilon(1e-14));
    const auto history = rows(run.file("thermo.csv"));
    REQUIRE(history.size() == 7);
    for (std::size_t k = 0; k < history.size(); ++k) {
        CHECK(history[k][0] == std::to_string(10 * k));
        CHECK(std::stod(history[k][1]) == Approx(0.04 * static_cast<double>(k)).epsilon(1e-14));
        REQUIRE(history[k].size() == 14);
    }
    CHECK(std::stod(history[0][13]) == Approx(1.0));  // the crystal is whole at the start
    CHECK(run.result.atoms == 108);
    CHECK(run.result.density == Approx(0.8).epsilon(1e-14));
    CHECK(run.result.search.rebuilds >= 1);
}

TEST_CASE("averages are over the rows of sampled stages, and over no others") {
    const Finished run(small_deck);
    const auto history = rows(run.file("thermo.csv"));
    double sum = 0.0;
    for (std::size_t k = 3; k < 7; ++k) {  // steps 30 to 60
        sum += std::stod(history[k][2]);
    }
    const auto& temperature = average(run.result, "temperature").estimate;
    REQUIRE(temperature.has_value());
    CHECK(temperature->samples == 4);
    CHECK(temperature->mean == Approx(sum / 4.0).epsilon(1e-13));
    REQUIRE(run.result.stages.size() == 2);
    CHECK_FALSE(run.result.stages[0].sampled);
    CHECK(run.result.stages[1].sampled);
    CHECK(run.result.stages[0].last_step == 20);
    CHECK(run.result.stages[1].first_step == 20);
    CHECK(run.result.stages[1].last_step == 60);
}

TEST_CASE("energy drift is told of stages without a thermostat, which hold their energy") {
    const Finished run(small_deck, {"stage.production.steps=100"});
    REQUIRE(run.result.stages.size() == 2);
    CHECK(run.result.stages[0].thermostatted);
    CHECK_FALSE(run.result.stages[0].energy_drift.has_value());
    CHECK_FALSE(run.result.stages[1].thermostatted);
    REQUIRE(run.result.stages[1].energy_drift.has_value());
    const auto history = rows(run.file("thermo.csv"));
    // slope of total energy against time from the rows of the stage itself
    double st = 0.0;
    double se = 0.0;
    double stt = 0.0;
    double ste = 0.0;
    const std::vector<std::vector<std::string>> own(history.begin() + 3, history.end());
    for (const auto& row : own) {
        const double t = std::stod(row[1]);
        const double e = std::stod(row[5]);
        st += t;
        se += e;
        stt += t * t;
        ste += t * e;
    }
    const auto n = static_cast<double>(own.size());
    CHECK(n == 10);
    CHECK(*run.result.stages[1].energy_drift == Approx((n * ste - st * se) / (n * stt - st * st)).epsilon(1e-4));
    CHECK(std::abs(*run.result.stages[1].energy_drift) < 1e-2);
}

TEST_CASE("a time step that makes pressures wrong is told of, though the energy does not drift") {
    const auto run = [](const std::string& time_step) {
        return Finished(small_deck, {"stage.production.steps=200", "stage.production.time_step=" + time_step,
                                     "system.temperature=0.722"});
    };
    const Finished usual = run("0.004");
    CHECK_FALSE(usual.result.stages[0].time_step_error.has_value());  // it is not sampled
    CHECK(usual.result.stages[1].time_step_error.value() == Approx(0.001).epsilon(0.4));
    CHECK_THAT(usual.file("results.txt"), !Contains("too long"));
    const Finished coarse = run("0.016");
    CHECK(coarse.result.stages[1].time_step_error.value() == Approx(0.016).epsilon(0.4));
    CHECK(coarse.result.stages[1].drift_remark.empty());
    CHECK_THAT(coarse.file("results.txt"),
               Contains("  warning: the time step of stage 'production' is too long: it sets"));
    CHECK(std::ranges::any_of(coarse.result.warnings, [](const std::string& warning) {
        return warning.starts_with("the time step of stage 'production' is too long: it sets the temperatures");
    }));
}

TEST_CASE("a thermostat holds the temperature of its stage") {
    const Finished run(small_deck, {"stage.equilibrate.temperature=1.7", "stage.production.steps=0"});
    CHECK(temperature(run.simulation.state).value() == Approx(1.7).epsilon(1e-13));
    CHECK(total_momentum(run.simulation.state).norm() < 1e-11);
}

TEST_CASE("a run of no steps evaluates its start once") {
    const Finished run(small_deck, {"stage.production.steps=0", "stage.equilibrate.steps=0", "analysis.rdf.bins=20"});
    CHECK(rows(run.file("thermo.csv")).size() == 1);
    CHECK(run.listener.steps.empty());
    CHECK(run.result.warnings.empty());
    for (const char* name : {"temperature", "potential_energy", "pressure", "virial"}) {
        const auto& estimate = average(run.result, name).estimate;
        REQUIRE(estimate.has_value());
        CHECK(estimate->samples == 1);
        CHECK(std::isfinite(estimate->mean));
    }
    CHECK(average(run.result, "temperature").estimate->mean == Approx(1.0).epsilon(1e-12));
    const Data json = parse_json(run.file("results.json"));
    CHECK(json.at("observables").at("virial").at("mean").is_number());
    CHECK(json.at("observables").at("pressure").at("standard_error").is_null());
    CHECK(json.at("stages")[1].at("steps") == 0);
    REQUIRE(run.result.tables.size() == 2);
    CHECK(run.result.tables[0].name == "rdf");
    CHECK(run.result.tables[1].name == "sk_from_rdf");
}

TEST_CASE("a stage of no steps among others samples nothing") {
    const Finished run(small_deck, {"stage.production.steps=0"});
    CHECK(run.result.averages.empty());
    CHECK_FALSE(run.result.order_at_sampling.has_value());
    CHECK(warned(run.result, "no sample was taken"));
}

TEST_CASE("doubts about the results are warnings, to the listener and in results.json") {
    const Finished run(small_deck);
    CHECK(warned(run.result, "of the crystal left"));  // after 20 steps
    CHECK(run.result.order_at_sampling.value() > 0.1);
    CHECK(warned(run.result, "too short for the error bars of all observables"));
    CHECK_FALSE(warned(run.result, "no sample"));
    CHECK(run.listener.warnings == run.result.warnings);
    CHECK(parse_json(run.file("results.json")).at("warnings") == Data(run.result.warnings));

    const Finished without(small_deck, {"stage.production.sample=false"});
    CHECK(without.result.warnings.size() == 1);
    CHECK(warned(without.result, "no sample was taken"));
}

TEST_CASE("lists that were kept too long are told of") {
    const std::vector<std::string> long_kept{"neighbors.every=20", "neighbors.skin=0.05"};
    const Finished late(small_deck, long_kept);
    CHECK(warned(late.result, "neighbor lists were kept too long"));
    CHECK(parse_json(late.file("results.json")).at("neighbor_list_late_rebuilds") == late.result.search.late_rebuilds);
    const Finished in_time(small_deck, {"neighbors.skin=0.05"});
    CHECK_FALSE(warned(in_time.result, "kept too long"));
    CHECK(parse_json(in_time.file("results.json")).at("neighbor_list_late_rebuilds") == 0);
}

TEST_CASE("a long run of a liquid leaves no doubt") {
    const Finished run(small_deck, {"stage.equilibrate.steps=600", "stage.equilibrate.temperature=3",
                                    "stage.production.steps=20000", "output.thermo.every=5"});
    INFO(to_json(run.result.warnings));
    CHECK(run.result.warnings.empty());
    CHECK(std::abs(run.result.order_at_sampling.value()) < 0.1);
}

TEST_CASE("what is measured and written changes no bit of the trajectory") {
    const Finished plain(small_deck);
    const std::string last = plain.file("final.xyz");
    CHECK(Finished(small_deck).file("final.xyz") == last);
    for (const std::vector<std::string>& settings : {std::vector<std::string>{"output.thermo.every=1"},
                                                     {"output.thermo.every=1000"},
                                                     {"stage.production.sample=false"},
                                                     {"analysis.rdf.every=1"},
                                                     {"output.trajectory.every=3", "output.trajectory.velocities=true"},
                                                     {"output.trajectory.every=7", "output.trajectory.format=xyz",
                                                      "analysis.rdf.every=2", "output.thermo.every=3"}}) {
        INFO(settings.front());
        CHECK(Finished(small_deck, settings).file("final.xyz") == last);
    }
    CHECK(Finished(small_deck, {"system.seed=8"}).file("final.xyz") != last);
}

TEST_CASE("analyses sample in sampled stages only, when they are due") {
    const auto samples = [](const std::vector<std::string>& settings) {
        const Finished run(small_deck, settings);
        return run.simulation.analyses.at(0)->samples();
    };
    CHECK(samples({"analysis.rdf.every=8"}) == 5);  // 24, 32, 40, 48, 56
    CHECK(samples({"analysis.rdf.every=1"}) == 40);
    CHECK(Finished(small_deck, {"analysis.rdf.every=1000"}).result.tables.empty());
}

TEST_CASE("what follows atoms through time begins anew with each stage") {
    const std::string deck = small_deck +
                             "\n[[stage]]\nname = \"more\"\ntime_step = 0.004\nsteps = 40\nsample = true\n" +
                             "[analysis]\nvacf = { every = 1, max_time = 0.1 }\n";  // windows of 40 configurations
    const auto rows = [&deck](const std::string& setting) {
        const Finished run(deck, {"stage.production.steps=30", setting});
        REQUIRE(run.result.tables.size() == 2);
        std::vector<std::vector<double>> numbers;
        for (const auto& row : run.result.tables[0].rows) {
            numbers.push_back({row[0], row[1]});
        }
        return numbers;
    };
    CHECK(rows("stage.production.sample=true") == rows("stage.production.sample=false"));
}

TEST_CASE("run.json tells a run that goes on from one that has ended") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    FluidSystem simulation = simulation_of(deck);
    prepare_directory(deck.directory);
    Recorder listener;
    int looks = 0;
    listener.at_step = [&](Index) {
        const Data record = parse_json(content_of(deck.directory / "run.json"));
        looks += record.at("finished") == false && record.at("ended").is_null() ? 1 : 0;
        CHECK_FALSE(std::filesystem::exists(deck.directory / "results.json"));
    };
    const RunResult result = run_plan(deck, simulation, listener);
    CHECK(looks == 60);
    const Data record = parse_json(content_of(deck.directory / "run.json"));
    CHECK(record.at("finished") == true);
    CHECK(record.at("seconds_in_time_loop") == result.seconds.sum());
    CHECK(record.at("seconds_per_phase").at("force").number() > 0.0);
}

TEST_CASE("a run that blows up ends with step, stage and the configuration") {
    const DeckFolder folder;
    Deck deck = folder.load({"system.temperature=20"});
    deck.stages()[1].time_step = 0.1;  // which a deck would need --force for
    FluidSystem simulation = simulation_of(deck);
    prepare_directory(deck.directory);
    Recorder listener;
    const auto run = [&] { static_cast<void>(run_plan(deck, simulation, listener)); };
    CHECK_THROWS_MATCHES(run(), PhysicsError, Catch::Matchers::Predicate<PhysicsError>([&](const PhysicsError& error) {
                             const std::string text = error.what();
                             return text.starts_with("step ") &&
                                    text.find("(stage 'production')") != std::string::npos &&
                                    text.find((deck.directory / "failed.xyz").string()) != std::string::npos;
                         }));
    CHECK(std::filesystem::exists(deck.directory / "failed.xyz"));
    CHECK_FALSE(std::filesystem::exists(deck.directory / "results.json"));
    CHECK_FALSE(std::filesystem::exists(deck.directory / "final.xyz"));
    CHECK(parse_json(content_of(deck.directory / "run.json")).at("finished") == false);
    CHECK(rows(content_of(deck.directory / "thermo.csv")).size() >= 3);  // what was measured until then is there
}

TEST_CASE("a bit-reversible fluid is back where it began, to the last bit, and another is not") {
    const auto checksums = [](const std::string& integrator) {
        const std::string choice = "integrator = \"" + integrator + "\"\n";
        const Finished run(
            changed(small_deck, {{"steps = 40\nsample = true\n", "steps = 400\nsample = true\n" + choice}}) +
                "\n[[stage]]\nname = \"back\"\ntime_step = 0.004\nsteps = 400\nreverse = true\n" + choice,
            {"stage.equilibrate.steps=0", "neighbors.skin=0.2"});
        CHECK(run.result.search.rebuilds > 10);
        REQUIRE(run.result.stages.size() == 3);
        CHECK(run.result.stages[2].reversed);
        CHECK(run.result.stages[2].checksum_at_start == run.result.stages[1].checksum_at_end);
        CHECK(run.result.stages[1].checksum_at_start != run.result.stages[1].checksum_at_end);
        return std::pair(run.result.stages[1].checksum_at_start, run.result.stages[2].checksum_at_end);
    };
    const auto [start, end] = checksums("bit-reversible");
    CHECK(end == start);
    const auto [other_start, other_end] = checksums("velocity-verlet");
    CHECK(other_start == start);
    CHECK(other_end != other_start);
}

TEST_CASE("under a thermostat the conserved energy is written, and its drift is told") {
    const Finished run(changed(small_deck, {{"thermostat = { type = \"rescale\", every = 5 }\n", ""},
                                            {"sample = true\n",
                                             "sample = true\nthermostat = { type = "
                                             "\"stochastic-rescaling\", time = 0.05 }\n"},
                                            {"steps = 40", "steps = 400"}}));
    const std::string csv = run.file("thermo.csv");
    const auto total = column(csv, "total_energy");
    const auto conserved = column(csv, "conserved_energy");
    REQUIRE(total.size() == 43);
    CHECK(total[1] == conserved[1]);  // at constant energy they are the same
    const auto spread = [](const std::vector<double>& x) {
        const auto [least, most] = std::minmax_element(x.begin() + 3, x.end());
        return *most - *least;
    };
    CHECK(spread(conserved) < 0.02 * spread(total));
    REQUIRE(run.result.stages.back().energy_drift.has_value());
    CHECK(std::abs(*run.result.stages.back().energy_drift) < 1e-3);
    CHECK(run.result.stages.back().thermostatted);
    const ObservableAverage capacity = average(run.result, "heat_capacity_cv");  // of so short a run with a reason only
    CHECK((capacity.estimate.has_value() || !capacity.remark.empty()));
}

TEST_CASE("at constant pressure the density is in thermo.csv and among the results, and no energy is conserved") {
    const std::string bath =
        "thermostat = { type = \"stochastic-rescaling\" }\n"
        "barostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5, every = 4 }\n";
    const Finished run(changed(small_deck, {{"sample = true\n", "sample = true\n" + bath}}));
    const std::string csv = run.file("thermo.csv");
    const auto density = column(csv, "density");
    CHECK(density[0] == Approx(0.8).epsilon(1e-12));
    CHECK(density[2] == density[0]);  // the first stage is at constant volume
    CHECK(density.back() != density[2]);
    CHECK(rows(csv).back()[13].size() > 3);
    CHECK_FALSE(run.result.stages.back().energy_drift.has_value());
    const double mean = (density[3] + density[4] + density[5] + density[6]) / 4.0;
    CHECK(average(run.result, "density").estimate->mean == Approx(mean).epsilon(1e-12));
    CHECK(run.result.density == Approx(108.0 / run.simulation.state.box().volume()).epsilon(1e-14));
    CHECK(parse_json(run.file("results.json"))["observables"].contains("density"));
    const Finished constant(small_deck);
    CHECK_FALSE(parse_json(constant.file("results.json"))["observables"].contains("density"));
}

TEST_CASE("analyses are made for the box that the barostat has left") {
    const std::string bath =
        "thermostat = { type = \"stochastic-rescaling\" }\n"
        "barostat = { type = \"stochastic-cell-rescaling\", pressure = 4.0, every = 1, time = 0.5 }\n";
    const std::string text = changed(
        small_deck, {{"thermostat = { type = \"rescale\", every = 5 }\n", bath}, {"cutoff = 2.0", "cutoff = 1.5"}});
    const Finished run(text + "[analysis]\nrdf = { bins = 50, every = 1 }\n");
    const double half = 0.5 * run.simulation.state.box().shortest_edge();
    CHECK(std::abs(half - 0.5 * std::cbrt(108.0 / 0.8)) > 1e-3);
    const auto r = column(run.file("rdf.csv"), "r");
    CHECK(r.back() == Approx(half * (1.0 - 0.5 / 50.0)).epsilon(1e-12));

    // A radius that no longer fits is an error of the run.
    const std::string tight = fmt::format("[analysis]\nrdf = {{ radius = {} }}\n", 0.5 * std::cbrt(108.0 / 0.8));
    CHECK_THROWS_AS(Finished(text + tight), PhysicsError);
    CHECK_THROWS_WITH(Finished(text + tight), Contains("in the box that the barostat has made") && Contains("radius"));
}

TEST_CASE("a barostat does not make the box smaller than two cutoffs") {
    const std::string bath =
        "thermostat = { type = \"stochastic-rescaling\" }\n"
        "barostat = { type = \"stochastic-cell-rescaling\", pressure = 30.0, every = 1, time = 0.1 }\n";
    const std::string text = changed(
        small_deck, {{"thermostat = { type = \"rescale\", every = 5 }\n", bath}, {"cutoff = 2.0", "cutoff = 2.56"}});
    CHECK_THROWS_WITH(Finished(text), Contains("less than two cutoffs") && Contains("stage 'equilibrate'"));
}
