#include "ljmd/run/run_in_directory.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/engine_fixtures.hpp"
#include "forces/made_external_force.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/simulation.hpp"
#include "ljmd/run/spec_deck.hpp"
#include "model/checksum.hpp"
#include "potentials/twelve_six.hpp"
#include "run/directory_report.hpp"
#include "run/held_run.hpp"
#include "run/recorded_run.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// What small_deck with these outputs and analyses says.
const std::string outputs_of_deck = R"(
[output]
trajectory = { format = "xyz", every = 7, velocities = true }
[analysis]
rdf = { bins = 20, every = 4 }
msd = { every = 2, max_time = 0.08 }
)";

FluidSpec analysed_spec() {
    FluidSpec spec = small_spec();
    spec.analyses = {analysis("rdf", {{"bins", 20}, {"every", 4}}),
                     analysis("msd", {{"every", 2}, {"max_time", 0.08}})};
    return spec;
}

const RunFiles files_of_deck{.title = "A small liquid",
                             .trajectory = TrajectoryOutput{.format = "xyz", .every = 7, .velocities = true}};

/// The files of a run whose bytes are promised. The last line of results.txt has the path.
std::string outputs_in(const std::filesystem::path& directory) {
    std::string all;
    for (const char* name : {"thermo.csv", "trajectory.xyz", "final.xyz", "rdf.csv", "msd.csv", "results.json"}) {
        all += fmt::format("== {}\n{}", name, content_of(directory / name));
    }
    const std::string table = content_of(directory / "results.txt");
    return all + table.substr(0, table.find("\nfiles: "));
}

void check_same_outputs(const std::filesystem::path& found, const std::filesystem::path& expected) {
    const bool same = outputs_in(found) == outputs_in(expected);  // no one reads both as text
    CHECK(same);
}

/// Asks to stop at a step.
struct StopAt : RunListener {
    explicit StopAt(Index when) : last(when) {}
    void step_done(Index step) override { now = step; }
    [[nodiscard]] Interruption interruption() const {
        return Interruption(std::nullopt, [this] {
            return now >= last ? std::optional(StopRequest{15, "the test"}) : std::nullopt;
        });
    }

    Index last;
    Index now = 0;
};

/// The mean speed, as an observable of the program.
struct MeanSpeed : Observer {
    [[nodiscard]] bool needs(Index step) const override { return step % 2 == 0; }
    void sample(const Snapshot& snapshot) override {
        series.add(Eigen::VectorXd::Constant(1, snapshot.velocities().colwise().norm().mean()));
    }
    void archive(Archive& a) override { a(series); }
    [[nodiscard]] ObserverRecord record() const override { return {name, "sigma/tau", 2, false}; }
    [[nodiscard]] std::optional<ObservableAverage> average() const override {
        return ObservableAverage{name, "", "sigma/tau", series.estimate(0)};
    }

    std::string name = "mean_speed";
    BlockingAccumulator series{1, Covariance::diagonal};
};

/// Sums up what it sees.
struct Sum : Observer {
    [[nodiscard]] bool needs(Index step) const override { return step % 3 == 0; }
    void sample(const Snapshot& snapshot) override { value += snapshot.velocities().norm(); }
    void archive(Archive& a) override { a(value); }
    double value = 0.0;
};

}  // namespace

TEST_CASE("a specification with a directory leaves the files of the deck that says the same, byte for byte") {
    const DeckFolder folder(small_deck + outputs_of_deck);
    const Deck deck = folder.load();
    prepare_directory(deck.directory);
    FluidSystem fluid = simulation_of(deck);
    Recorder nobody;
    const RunResult of_deck = run_plan(deck, fluid, nobody);

    const RunResult result = run_in_directory(analysed_spec(), folder / "mine", {.files = files_of_deck});
    check_same_outputs(folder / "mine", deck.directory);
    CHECK(result.observable("pressure").estimate->mean == of_deck.observable("pressure").estimate->mean);
    CHECK(result.table("rdf").rows == of_deck.table("rdf").rows);
    CHECK(result.warnings == of_deck.warnings);
    Simulation in_memory(analysed_spec());
    in_memory.run();
    CHECK(result.stages.back().checksum_at_end == checksum(in_memory.state()));
}

TEST_CASE("a run with a directory that is stopped at any step ends, resumed, as if it had not been stopped") {
    const TemporaryFolder folder;
    Sum all;
    run_in_directory(analysed_spec(), folder / "whole", {.files = files_of_deck, .observers = {&all}});
    for (const Index step : {1, 7, 20, 21, 44, 59}) {
        INFO(step);
        const std::filesystem::path directory = folder / fmt::format("stopped-{}", step);
        StopAt stop(step);
        Sum before;
        CHECK_THROWS_AS(run_in_directory(analysed_spec(), directory,
                                         {.files = files_of_deck,
                                          .interruption = stop.interruption(),
                                          .observers = {&before},
                                          .listener = &stop}),
                        Interrupted);
        CHECK(stop.now == step);
        Sum after;
        const RunResult result = resume_in_directory(directory, {.threads = 2, .observers = {&after}});
        check_same_outputs(directory, folder / "whole");
        CHECK(after.value == all.value);
        CHECK(result.stages.size() == 2);
    }
}

TEST_CASE("a run with observers is resumed with as many, by whoever has them") {
    const TemporaryFolder folder;
    StopAt stop(30);
    Sum sum;
    CHECK_THROWS_AS(run_in_directory(small_spec(), folder / "run",
                                     {.interruption = stop.interruption(), .observers = {&sum}, .listener = &stop}),
                    Interrupted);
    CHECK_THROWS_AS(resume_in_directory(folder / "run"), CheckpointError);
    CHECK_THROWS_WITH(resume_in_directory(folder / "run"),
                      Contains("run was begun with the observable (unnamed); given: no observables\n  to go on: "
                               "resume_in_directory(\"") &&
                          Contains("in the program that began it"));
    CHECK_THROWS_AS(HeldRun(folder / "run", 0, 0, no_warnings), CheckpointError);  // as the command line resumes it
    Sum again;
    CHECK_NOTHROW(resume_in_directory(folder / "run", {.observers = {&again}}));
}

TEST_CASE("results of observers are in results.json and results.txt, bit for bit after an interruption") {
    const TemporaryFolder folder;
    MeanSpeed whole;
    const RunResult result =
        run_in_directory(small_spec(), folder / "whole", {.files = files_of_deck, .observers = {&whole}});
    CHECK(result.observable("mean_speed").own);
    CHECK_FALSE(result.observable("pressure").own);
    StopAt stop(33);
    MeanSpeed before;
    CHECK_THROWS_AS(
        run_in_directory(
            small_spec(), folder / "run",
            {.files = files_of_deck, .interruption = stop.interruption(), .observers = {&before}, .listener = &stop}),
        Interrupted);
    MeanSpeed other;
    other.name = "speed";
    CHECK_THROWS_WITH(resume_in_directory(folder / "run", {.observers = {&other}}),
                      Contains("was begun with the observable 'mean_speed' (every 2 steps, sigma/tau); given: the "
                               "observable 'speed' (every 2 steps, sigma/tau)"));
    MeanSpeed after;
    resume_in_directory(folder / "run", {.observers = {&after}});
    for (const char* name : {"results.json", "thermo.csv", "trajectory.xyz", "final.xyz"}) {
        INFO(name);
        CHECK(content_of(folder / "run" / name) == content_of(folder / "whole" / name));
    }
    const Data found = parse_json(content_of(folder / "run" / "results.json")).at("observables").at("mean_speed");
    CHECK(found.at("mean") == whole.series.estimate(0).mean);
    CHECK(found.at("own") == true);
    const std::string table = content_of(folder / "run" / "results.txt");
    CHECK_THAT(table, Contains("  mean_speed              own ") && Contains("own: measured by the program"));
    const Data record = parse_json(content_of(folder / "run" / "run.json")).at("given");
    CHECK(record.at("by") == "C++");
    CHECK(record.at("potential").is_null());
    CHECK(record.at("observables").at(0) ==
          Data({{"name", "mean_speed"}, {"unit", "sigma/tau"}, {"every", 2}, {"energy", false}}));
}

TEST_CASE("a formula of the program runs in a directory, and is given again to a run that is resumed") {
    const TemporaryFolder folder;
    const auto own = [](double cutoff) {
        return PairPotential::custom("twelve-six", TwelveSix{}, "shifted", {cutoff, 0.0});
    };
    FluidSpec spec = analysed_spec();
    spec.potential = own(2.0);
    run_in_directory(spec, folder / "whole", {.files = files_of_deck});
    Simulation in_memory(spec);
    StopAt stop(33);
    CHECK_THROWS_AS(run_in_directory(spec, folder / "run",
                                     {.files = files_of_deck, .interruption = stop.interruption(), .listener = &stop}),
                    Interrupted);
    CHECK_THROWS_WITH(resume_in_directory(folder / "run"),
                      Contains("the pair potential 'twelve-six' of this run is a formula of the C++ program"));
    CHECK_THROWS_AS(resume_in_directory(folder / "run", {.potential = own(1.9)}), CheckpointError);
    CHECK_THROWS_WITH(resume_in_directory(folder / "run", {.potential = own(1.9)}),
                      Contains("begun with the pair potential 'twelve-six', shifted at 2, and another one is given"));
    CHECK_THROWS_AS(HeldRun(folder / "run", 0, 0, no_warnings), CheckpointError);  // as the command line resumes it
    const RunResult result = resume_in_directory(folder / "run", {.potential = own(2.0)});
    check_same_outputs(folder / "run", folder / "whole");
    CHECK(result.stages.back().checksum_at_end == in_memory.run().stages.back().checksum_at_end);
    const Data potential = parse_json(content_of(folder / "run" / "run.json")).at("given").at("potential");
    CHECK(potential.at("name") == "twelve-six");
    CHECK(potential.at("table").is_null());
    CHECK_THAT(directory_report(folder / "run").text, Contains("run with      the pair potential 'twelve-six'"));

    run_in_directory(small_spec(), folder / "plain");
    CHECK_THROWS_WITH(resume_in_directory(folder / "plain", {.potential = own(2.0)}),
                      Contains("was run with the potential of its deck, and another one is given"));
}

TEST_CASE("a run under an external force is resumed with it, to the last bit, and no deck tells it") {
    const TemporaryFolder folder;
    FluidSpec spec = analysed_spec();
    spec.external = wave(2.0);
    run_in_directory(spec, folder / "whole", {.files = files_of_deck});
    CHECK_THAT(content_of(folder / "whole" / "run.json"), Contains("\"external_force\": \"wave\""));
    CHECK_THAT(content_of(folder / "whole" / "thermo.csv"), Contains(",external_energy,"));
    for (const Index step : {1, 20, 44}) {
        INFO(step);
        const std::filesystem::path directory = folder / fmt::format("stopped-{}", step);
        StopAt stop(step);
        CHECK_THROWS_AS(
            run_in_directory(spec, directory,
                             {.files = files_of_deck, .interruption = stop.interruption(), .listener = &stop}),
            Interrupted);
        CHECK_THROWS_WITH(resume_in_directory(directory),
                          Contains("was begun with the external force 'wave'; given: no external force"));
        CHECK_THROWS_WITH(HeldRun(directory, 0, 0, no_warnings),  // as the command line resumes it
                          Contains("was run with the external force 'wave' of a program in C++"));
        CHECK_THROWS_AS(resume_in_directory(directory, {.external = trap(1.0)}), CheckpointError);
        resume_in_directory(directory, {.threads = 2, .external = wave(2.0)});
        check_same_outputs(directory, folder / "whole");
    }
    CHECK_THROWS_WITH(deck_text(spec), Contains("'wave' is a force of the program, which no deck can name"));
    Diagnostics diagnostics;
    CHECK(recorded_deck(folder / "whole", {}, diagnostics).given.external == "wave");
    CHECK_THAT(directory_report(folder / "whole").text,
               Contains("run with      the external force 'wave', of a program in C++"));
    run_in_directory(small_spec(), folder / "without");
    CHECK_THROWS_WITH(resume_in_directory(folder / "without", {.external = wave(2.0)}),
                      Contains("was begun with no external force; given: the external force 'wave'"));
    CHECK(content_of(folder / "without" / "run.json").find("external_force") == std::string::npos);
}

TEST_CASE("its directory is that of a run, for the commands, too") {
    const TemporaryFolder folder;
    StopAt stop(30);
    CHECK_THROWS_WITH(
        run_in_directory(small_spec(), folder / "run", {.interruption = stop.interruption(), .listener = &stop}),
        Contains("stopped after step 30 by the test"));
    const Document report = directory_report(folder / "run");
    CHECK(report.data.at("finished") == false);
    CHECK(report.data.at("checkpoint").at("step") == 30);
    HeldRun run(folder / "run", 0, 0, no_warnings);  // as `ljmd resume` holds it
    CHECK_FALSE(run.is_at_its_end());
    CHECK_THROWS_AS(resume_in_directory(folder / "run"), InUseError);
}

TEST_CASE("a finished run is made longer, or writes its results anew") {
    const TemporaryFolder folder;
    run_in_directory(small_spec(), folder / "run");
    const std::string before = content_of(folder / "run" / "results.json");
    CHECK(resume_in_directory(folder / "run").stages.back().last_step == 60);
    CHECK(content_of(folder / "run" / "results.json") == before);
    CHECK(resume_in_directory(folder / "run", {.more_steps = 15}).stages.back().last_step == 75);
    CHECK_THROWS_AS(resume_in_directory(folder / "run", {.more_steps = -1}), InputError);
    CHECK_THROWS_AS(resume_in_directory(folder / "run", {.threads = -1}), InputError);
    CHECK_THROWS_AS(resume_in_directory(folder / "none"), DataError);
}

TEST_CASE("an earlier run is replaced only if that is asked for, and no message speaks of commands") {
    const TemporaryFolder folder;
    run_in_directory(small_spec(), folder / "run");
    const std::string before = content_of(folder / "run" / "thermo.csv");
    FluidSpec other = small_spec();
    other.seed = other.stages[0].seed = other.stages[1].seed = 8;
    CHECK_THROWS_AS(run_in_directory(other, folder / "run"), InputError);
    CHECK_THROWS_WITH(run_in_directory(other, folder / "run"),
                      Contains("already holds a run (run.json). Nothing was run.\n  choose another directory, or "
                               "replace it, or resume it") &&
                          !Contains("--"));
    CHECK(content_of(folder / "run" / "thermo.csv") == before);
    run_in_directory(other, folder / "run", {.replace = true});
    CHECK(content_of(folder / "run" / "thermo.csv") != before);
    std::ofstream(folder / "file") << "mine";
    CHECK_THROWS_WITH(run_in_directory(other, folder / "file"), Contains("is not a directory"));
    CHECK_THROWS_WITH(run_in_directory(other, ""), Contains("name of the directory is empty"));
}

TEST_CASE("mistakes of a specification, and of its files, leave no directory") {
    const TemporaryFolder folder;
    const std::filesystem::path directory = folder / "run";
    FluidSpec wrong = small_spec();
    wrong.stages[1].time_step = -1.0;
    CHECK_THROWS_AS(run_in_directory(wrong, directory), InputError);
    CHECK_THROWS_WITH(
        run_in_directory(small_spec(), directory, {.files = {.trajectory = TrajectoryOutput{.every = 0}}}),
        Contains("'every' in trajectory is 0") && !Contains("error:"));
    CHECK_THROWS_WITH(
        run_in_directory(small_spec(), directory, {.files = {.trajectory = TrajectoryOutput{.format = "dcd"}}}),
        Contains("dcd") && Contains("h5md"));
    CHECK_THROWS_WITH(
        run_in_directory(small_spec(), directory, {.files = {.trajectory = TrajectoryOutput{.units = "si"}}}),
        Contains("needs an [argon] table"));
    CHECK_FALSE(std::filesystem::exists(directory));
}

TEST_CASE("a configuration that a run starts from is kept in its directory, where its deck finds it") {
    const TemporaryFolder folder;
    Simulation earlier(small_spec());
    earlier.run();
    Configuration start{.edges = earlier.state().box().edges()};
    for (Index i = 0; i < earlier.state().count(); ++i) {
        start.positions.emplace_back(earlier.state().positions().col(i));
        start.velocities.emplace_back(earlier.state().velocities().col(i));
    }
    FluidSpec spec = small_spec();
    spec.start = start;
    StopAt stop(30);
    CHECK_THROWS_AS(run_in_directory(spec, folder / "run", {.interruption = stop.interruption(), .listener = &stop}),
                    Interrupted);
    const RunResult result = resume_in_directory(folder / "run");
    Simulation in_memory(spec);
    in_memory.run();
    CHECK(result.stages.back().checksum_at_end == checksum(in_memory.state()));
    REQUIRE(std::filesystem::exists(folder / "run" / given_start_name));

    // The deck in the record makes the same run from the kept configuration.
    const Data record = parse_json(content_of(folder / "run" / "run.json"));
    const DeckFolder again(record.at("deck").text());
    const Deck deck = again.load();
    prepare_directory(deck.directory);
    FluidSystem fluid = simulation_of(deck);
    Recorder nobody;
    CHECK(run_plan(deck, fluid, nobody).stages.back().checksum_at_end == result.stages.back().checksum_at_end);

    run_in_directory(small_spec(), folder / "run", {.replace = true});  // which starts from a lattice
    CHECK_FALSE(std::filesystem::exists(folder / "run" / given_start_name));
}

TEST_CASE("a listener hears of stages, steps and warnings, and the results have the warnings") {
    const TemporaryFolder folder;
    Recorder listener;
    FluidSpec spec = small_spec();
    spec.start = Configuration{.edges = Vec3::Constant(6.0),
                               .positions = {Vec3::Zero(), Vec3::Constant(3.0)},
                               .velocities = {Vec3::Ones(), Vec3::Zero()}};
    const RunResult result = run_in_directory(spec, folder / "run", {.listener = &listener});
    CHECK(listener.stages == std::vector<std::string>{"equilibrate", "production"});
    CHECK(listener.steps.size() == 60);
    REQUIRE_FALSE(result.warnings.empty());
    CHECK_THAT(result.warnings.front(), Contains("the centre of mass moved"));
    CHECK(listener.warnings == result.warnings);
}

TEST_CASE("what an observer throws ends the run, which is resumed from its last checkpoint") {
    struct Thrower : Sum {
        explicit Thrower(bool throws) : throws_(throws) {}
        void sample(const Snapshot& snapshot) override {
            Sum::sample(snapshot);
            if (throws_ && snapshot.step() == 45) {
                throw std::runtime_error("enough");
            }
        }
        bool throws_;
    };
    const TemporaryFolder folder;
    Thrower first(true);
    CHECK_THROWS_WITH(run_in_directory(small_spec(), folder / "run", {.observers = {&first}}), "enough");
    Thrower second(false);
    resume_in_directory(folder / "run", {.observers = {&second}});
    Sum whole;
    Simulation in_memory(small_spec());
    in_memory.add(whole);
    in_memory.run();
    CHECK(second.value == whole.value);
}
