#include "run/run_checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <set>

#include "deck/every_analysis.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "io/formats/trajectory_reader.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "run/recorded_run.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// Everything that a deck's run leaves, file by file; times and what tells of them left out.
std::string outputs_of(const std::filesystem::path& directory) {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        const auto extension = entry.path().extension();
        if (extension == ".csv" || extension == ".xyz" || extension == ".h5md") {
            files.insert(entry.path());
        }
    }
    std::string all;
    for (const std::filesystem::path& file : files) {
        all += fmt::format("== {}\n{}", file.filename().string(), content_of(file));
    }
    return all + content_of(directory / "results.json");
}

/// Stop a run at every step and resume it: it must end like the run that was not stopped.
/// @param threads  0: as OMP_NUM_THREADS says
/// @param apart    steps from one at which it is stopped to the next
/// @return how often that has built its neighbour list
Index check_every_step(const std::string& text, const std::vector<std::string>& settings, int threads = 0,
                       Index apart = 1) {
    const DeckFolder whole_folder(text);
    const Deck whole = whole_folder.load(settings);
    run_until(whole, total_steps(whole.stages()), threads);
    const std::string expected = outputs_of(whole.directory);
    Index wrong = 0;
    for (Index step = 0; step < total_steps(whole.stages()); step += apart) {
        const DeckFolder folder(text);
        std::vector<std::string> with_checkpoint = settings;
        with_checkpoint.push_back(fmt::format("output.checkpoint.every={}", std::max<Index>(step, 1)));
        const Deck deck = folder.load(with_checkpoint);
        run_until(deck, step, threads);
        const Index resumed_at = resume(deck.directory, threads);
        CHECK(resumed_at == step);
        if (outputs_of(deck.directory) != expected) {
            ++wrong;
            UNSCOPED_INFO("stopped after step " << step);
        }
    }
    CHECK(wrong == 0);
    const Data results = parse_json(content_of(whole.directory / "results.json"));
    const Data* rebuilds = results.find("neighbor_list_rebuilds");  // of fluids
    return rebuilds != nullptr ? rebuilds->integer() : 0;
}

const std::string with_files = small_deck + R"(
[output]
trajectory = { format = "xyz", every = 7, velocities = true }
)" +
                               every_analysis({{"rdf", "{ bins = 20, every = 4 }"},
                                               {"structure_factor", "{ k_max = 3.0, every = 4 }"},
                                               {"msd", "{ every = 2, origins = 3 }"},
                                               {"chemical_potential", "{ every = 3, insertions = 5 }"}});

/// The same of 4 cells^3 atoms in both precisions, while two lists and more come and go.
void check_every_step(const IntegratorMethod& method, const ThermostatMethod& thermostat, int cells, int threads,
                      Index apart) {
    const std::string text =
        thermostat.name == "rescale"
            ? with_files
            : changed(with_files, {{"type = \"rescale\", every = 5", "type = \"" + thermostat.name + "\""}});
    for (const char* precision : {"double", "mixed"}) {
        INFO(method.name << ", " << thermostat.name << ", " << precision);
        const Index rebuilds = check_every_step(
            text,
            {fmt::format("system.lattice.cells={}", cells), fmt::format("performance.precision=\"{}\"", precision),
             "neighbors.skin=0.05", "stage.equilibrate.integrator=\"" + method.name + "\"",
             "stage.production.integrator=\"" + method.name + "\"",
             "stage.equilibrate.time_step=0.001",  // Euler heats
             "stage.production.time_step=0.001", "stage.equilibrate.steps=10", "stage.production.steps=20"},
            threads, apart);
        CHECK(rebuilds >= 3);  // two lists have come and gone
    }
}

bool go_together(const IntegratorMethod& method, const ThermostatMethod& thermostat) {
    return !method.unbounded_only && (!thermostat.every_step || method.name == "velocity-verlet");
}

/// Every integrator, with the simplest thermostat, and every thermostat, with velocity Verlet.
template <class Check>
void for_each_method(const Check& check) {
    for (const IntegratorMethod& method : all_integrators()) {
        for (const ThermostatMethod& thermostat : all_thermostats()) {
            const bool new_here = method.name == "velocity-verlet" || thermostat.name == "rescale";
            if (new_here && go_together(method, thermostat)) {
                check(method, thermostat);
            }
        }
    }
}

}  // namespace

TEST_CASE("a fluid that is stopped after any step and resumed ends as if it had not been stopped") {
    CHECK(check_every_step(with_files, {"neighbors.skin=0.15"}) >= 3);
}

TEST_CASE("so it is with every way to the neighbours and in mixed precision") {
    for (const char* setting : {"neighbors.method=\"all-pairs\"", "neighbors.method=\"cells\"", "neighbors.every=7",
                                "performance.precision=\"mixed\""}) {
        INFO(setting);
        check_every_step(with_files, {setting});
    }
}

TEST_CASE("so it is with frames in every format") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        check_every_step(changed(with_files, {{"format = \"xyz\"", "format = \"" + format + "\""}}), {});
    }
}

TEST_CASE("so it is with every integrator, and every thermostat of fluids, in both precisions") {
    for_each_method([](const IntegratorMethod& method, const ThermostatMethod& thermostat) {
        check_every_step(method, thermostat, 3, 1, 1);
    });
}

TEST_CASE("so it is after every fourth step with every integrator under every thermostat, in both precisions",
          "[long]") {
    for (const IntegratorMethod& method : all_integrators()) {
        for (const ThermostatMethod& thermostat : all_thermostats()) {
            if (go_together(method, thermostat)) {
                check_every_step(method, thermostat, 3, 1, 4);
            }
        }
    }
}

TEST_CASE("so it is after every seventh step with two threads, every integrator and thermostat, in both precisions",
          "[long]") {
    constexpr int cells = 6;  // the least that gives two threads something to share
    for_each_method([](const IntegratorMethod& method, const ThermostatMethod& thermostat) {
        check_every_step(method, thermostat, cells, 2, 7);
    });
}

TEST_CASE("so it is with a thermostat while samples are taken, and with a barostat before it") {
    const int threads = GENERATE(1, 2);
    const std::string text =
        changed(with_files, {{"thermostat = { type = \"rescale\", every = 5 }",
                              "thermostat = { type = \"nose-hoover-chain\" }\n"
                              "barostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5, every = 3 }"},
                             {"sample = true\n", "sample = true\nthermostat = { type = \"nose-hoover-chain\" }\n"},
                             {"bulk_viscosity = { every = 1 }\n", ""}});  // which needs a constant energy
    check_every_step(text, {"stage.equilibrate.steps=10", "stage.production.steps=20"}, threads);
}

TEST_CASE("so it is while a barostat changes the box and samples are taken") {
    const std::string text =
        changed(small_deck, {{"sample = true\n",
                              "sample = true\nthermostat = { type = \"stochastic-rescaling\" }\n"
                              "barostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5, every = 3 }\n"}}) +
        "[output]\ntrajectory = { format = \"xyz\", every = 7, velocities = true }\n"
        "[analysis]\nresponse_functions = { every = 2 }\nconfigurational_temperature = { every = 3 }\n";
    check_every_step(text, {"stage.equilibrate.steps=5", "stage.production.steps=25"});
}

TEST_CASE("so it is with a stage that begins at a given total energy") {
    check_every_step(changed(with_files, {{"sample = true\n", "sample = true\ntotal_energy = -3.0\n"}}),
                     {"stage.equilibrate.steps=10", "stage.production.steps=20"});
}

TEST_CASE("so it is with few bodies, every integrator, and a stage that goes backwards") {
    for (const IntegratorMethod& method : all_integrators()) {
        INFO(method.name);
        const std::string integrator = "integrator = \"" + method.name + "\"\n";
        const std::string text =
            changed(stars_deck, {{"steps = 95\n", "steps = 40\nsample = true\n" + integrator +
                                                      "[[stage]]\nname = \"back\"\ntime_step = 0.01\nsteps = 20\n"
                                                      "reverse = true\nsample = false\n" +
                                                      integrator}}) +
            "trajectory = { format = \"csv\", every = 3 }\n[analysis]\norbit = { body = 1, about = 2 }\n"
            "closest_approach = {}\n";
        check_every_step(text, {});
    }
    check_every_step(radial_deck, {});
}

TEST_CASE("run.json tells at which steps a run was resumed, and when it began") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 33);
    const Data before = parse_json(content_of(deck.directory / "run.json"));
    CHECK(resume(deck.directory) == 30);
    const Data record = parse_json(content_of(deck.directory / "run.json"));
    CHECK(record["resumed_at_steps"] == Data::list({30}));
    CHECK(record["began"] == before["began"]);
    CHECK(record["finished"] == true);
    CHECK(record["deck_hash"] == before["deck_hash"]);
}

TEST_CASE("a finished run is resumed from its end, and ends the same") {
    const DeckFolder folder(with_files);
    const Deck deck = folder.load();
    run_until(deck, total_steps(deck.stages()));
    const std::string expected = outputs_of(deck.directory);
    CHECK(resume(deck.directory) == total_steps(deck.stages()));
    CHECK(outputs_of(deck.directory) == expected);
}

TEST_CASE("of a damaged newest checkpoint the older one is taken, and that is said") {
    const DeckFolder folder(with_files);
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 35);
    const auto newest = find_continuation(deck)->file.path;
    std::filesystem::resize_file(newest, std::filesystem::file_size(newest) - 1);
    const auto point = find_continuation(recorded_run(deck.directory).deck);
    REQUIRE(point.has_value());
    CHECK(point->head.step == 20);
    REQUIRE(point->warnings.size() == 1);
    CHECK_THAT(point->warnings[0], Contains(newest.string()) && Contains("damaged") && Contains("resuming from"));
    CHECK(resume(deck.directory) == 20);

    const DeckFolder whole_folder(with_files);
    const Deck whole = whole_folder.load();
    run_until(whole, total_steps(whole.stages()));
    CHECK(outputs_of(deck.directory) == outputs_of(whole.directory));
}

TEST_CASE("outputs that are shorter than the checkpoint knew them are refused, and nothing is touched") {
    const DeckFolder folder(with_files);
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 35);
    const std::string record = content_of(deck.directory / "run.json");
    std::filesystem::resize_file(deck.directory / "thermo.csv", 10);
    CHECK_THROWS_AS(resume(deck.directory), CheckpointError);
    CHECK(std::filesystem::file_size(deck.directory / "thermo.csv") == 10);
    CHECK(content_of(deck.directory / "run.json") == record);
}

TEST_CASE("all outputs are looked at before the first one is changed") {
    for (const std::string& format : plugin_names(all_trajectory_formats())) {
        INFO(format);
        const DeckFolder folder(changed(with_files, {{"\"xyz\"", '"' + format + '"'}}));
        const Deck deck = folder.load({"output.checkpoint.every=10"});
        run_until(deck, 35);
        const auto trajectory = deck.directory / ("trajectory." + format);
        const std::string thermo = content_of(deck.directory / "thermo.csv");
        const std::string record = content_of(deck.directory / "run.json");
        std::filesystem::resize_file(trajectory, 700);
        CHECK_THROWS_AS(resume(deck.directory), CheckpointError);
        CHECK(std::filesystem::file_size(trajectory) == 700);
        CHECK(content_of(deck.directory / "thermo.csv") == thermo);
        CHECK(content_of(deck.directory / "run.json") == record);
        for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(deck.directory)) {
            CHECK_FALSE(entry.path().filename().string().starts_with("."));
        }
    }
}

TEST_CASE("a frame that is not what was written is refused, and nothing is touched") {
    const DeckFolder folder(changed(with_files, {{"format = \"xyz\"", "format = \"h5md\""}}));
    const Deck deck = folder.load({"output.checkpoint.every=10"});
    run_until(deck, 35);
    const auto trajectory = deck.directory / "trajectory.h5md";
    std::string bytes = content_of(trajectory);
    const auto reader = open_trajectory(trajectory, std::nullopt);
    Frame frame;
    do {
        REQUIRE(reader->next(frame));
    } while (frame.configuration.step != 28);  // the last one that the checkpoint knows
    const double x = frame.configuration.positions[17][0];
    const std::size_t place = bytes.find(std::string(reinterpret_cast<const char*>(&x), sizeof x));
    REQUIRE(place != std::string::npos);
    bytes[place] = static_cast<char>(bytes[place] ^ 1);
    std::ofstream(trajectory, std::ios::binary) << bytes;
    const std::string record = content_of(deck.directory / "run.json");
    CHECK_THROWS_AS(resume(deck.directory), CheckpointError);
    CHECK_THROWS_WITH(resume(deck.directory),
                      Contains("the frame of step 28 in ") && Contains("is not what was written"));
    CHECK(content_of(trajectory) == bytes);
    CHECK(content_of(deck.directory / "run.json") == record);
}

TEST_CASE("checkpoints are written by wall time, and as many are kept as is wished") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint={every=\"0.000001 s\",keep=3}", "stage.production.steps=3000"});
    run_until(deck, 2500);
    CHECK(find_continuation(deck)->head.step > 2000);  // at the end of the first stage, were it for steps alone
    const auto names = checkpoint_names();
    CHECK(std::count_if(names.begin(), names.end(),
                        [&](const std::string& name) { return std::filesystem::exists(deck.directory / name); }) == 3);
}

TEST_CASE("no checkpoint is written of a run that has blown up") {
    const DeckFolder folder(with_files);
    const Deck deck = folder.load({"output.checkpoint.every=1"});
    prepare_directory(deck.directory);
    FluidSystem simulation = simulation_of(deck);
    Recorder listener;
    listener.at_step = [&](Index step) {
        if (step == 33) {
            simulation.state.write_velocities().col(5) = Vec3(0.0, 1000.0, 0.0);
        }
    };
    CHECK_THROWS_WITH(run_plan(deck, simulation, listener), Contains("step 33 ") && Contains("has blown up"));
    CHECK(std::filesystem::exists(deck.directory / "failed.xyz"));
    CHECK(resume(deck.directory) == 32);
}

TEST_CASE("a run whose time is over stops with a checkpoint, and can be resumed") {
    const DeckFolder folder(with_files);
    const Deck deck = folder.load({"stage.production.steps=2000"});
    prepare_directory(deck.directory);
    Recorder listener;
    try {
        run_in(deck, listener, {.interruption = Interruption(1e-9)});
        FAIL("the run went on");
    } catch (const Interrupted& stopped) {
        CHECK(stopped.exit_code() == 75);
        CHECK_THAT(stopped.what(), Contains("the end of its wall time") && Contains("ljmd resume"));
    }
    CHECK(listener.steps.size() < 100);
    CHECK(resume(deck.directory) == std::ssize(listener.steps));
}
