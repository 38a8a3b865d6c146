#include "ljmd/analyze/trajectory.hpp"

#include <algorithm>
#include <utility>

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/run/run_in_directory.hpp"
#include "potentials/twelve_six.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

constexpr Index every = 5;

/// A sampled run of a small liquid, whose frames are those that its g(r) is averaged over.
struct RunWithFrames {
    explicit RunWithFrames(const FluidSpec& fluid) : spec(fluid) {
        spec.stages = {{.name = "production", .time_step = 0.004, .steps = 40, .sample = true}};
        spec.sample_every = every;
        spec.analyses = {analysis("rdf", {{"bins", 30}, {"every", every}})};
        result = run_in_directory(
            spec, folder / "run",
            {.files = {.trajectory = TrajectoryOutput{.format = "xyz", .every = every, .velocities = true}}});
    }

    [[nodiscard]] std::filesystem::path file() const { return folder / "run" / "trajectory.xyz"; }

    TemporaryFolder folder;
    FluidSpec spec;
    RunResult result;
};

const ObservableAverage* found(const std::vector<ObservableAverage>& averages, const std::string& name) {
    const auto one = std::ranges::find(averages, name, &ObservableAverage::name);
    return one == averages.end() ? nullptr : &*one;
}

}  // namespace

TEST_CASE("a program reads the frames of a file, and finds in them what the run has found") {
    const RunWithFrames run(small_spec());
    const Trajectory frames(run.file());
    CHECK(frames.atoms() == atoms_of(run.spec));
    CHECK(frames.frames() == 9);  // with the start
    CHECK(frames.has_velocities());
    CHECK(frames.spacing().value() == Approx(every * 0.004));
    CHECK(frames.times().back() == Approx(40 * 0.004));
    CHECK(frames.edges()[0] == box_of(run.spec).edges()[0]);

    std::vector<Index> steps;
    frames.each([&](const Configuration& frame) {
        CHECK(std::ssize(frame.positions) == frames.atoms());
        steps.push_back(frame.step.value());
    });
    CHECK(steps == std::vector<Index>{0, 5, 10, 15, 20, 25, 30, 35, 40});

    // The start is no sample of the run.
    const Trajectory sampled(run.file(), {.from = 0.5 * every * 0.004});
    const TrajectoryResult of_frames = sampled.analyze({analysis("rdf", {{"bins", 30}, {"every", 1}})});
    REQUIRE(of_frames.tables.front().name == "rdf");
    const DataTable& in_run = run.result.table("rdf");
    REQUIRE(of_frames.tables.front().rows.size() == in_run.rows.size());
    for (std::size_t k = 0; k < in_run.rows.size(); ++k) {
        CHECK(of_frames.tables.front().rows[k][1] == Approx(in_run.rows[k][1]).margin(1e-12));
    }
    CHECK(found(of_frames.averages, "temperature") != nullptr);
    CHECK(found(of_frames.averages, "potential_energy") == nullptr);
}

TEST_CASE("with the fluid that they are of, frames have energies, of a formula of the program too") {
    FluidSpec own = small_spec();
    own.potential =
        PairPotential::custom("twelve-six", TwelveSix{}, own.potential.truncation(), own.potential.cutoff());
    const RunWithFrames run(own);
    const Trajectory frames(run.file(), {.fluid = run.spec, .energies = true, .from = 0.5 * every * 0.004});
    const TrajectoryResult result = frames.analyze({analysis("rdf")});
    const ObservableAverage* energy = found(result.averages, "potential_energy");
    REQUIRE(energy != nullptr);
    CHECK(energy->estimate->mean == Approx(run.result.observable("potential_energy").estimate->mean).epsilon(1e-12));
}

TEST_CASE("without names a program gets the analyses that go with the file, and it hears of what does not fit") {
    const RunWithFrames run(small_spec());
    const Trajectory frames(run.file());
    const TrajectoryResult result = frames.analyze();
    std::vector<std::string> names;
    for (const DataTable& table : result.tables) {
        names.push_back(table.name);
    }
    CHECK(names == std::vector<std::string>{"rdf", "sk_from_rdf", "sk", "msd"});
    CHECK_THROWS_WITH(frames.analyze({analysis("chemical_potential")}), Contains("needs the interaction"));
    CHECK_THROWS_WITH(frames.analyze({Choice{"rdff", {}}}), Contains("did you mean 'rdf'?"));
    CHECK_THROWS_AS(frames.analyze({Choice{"rdf", {{"bins", -3}}}}), InputError);
    CHECK_THROWS_AS(Trajectory(run.folder / "none.h5"), DataError);
    CHECK_THROWS_WITH(Trajectory(run.file(), {.from = 7.0}), Contains("is as late"));
}

TEST_CASE("a trajectory that was moved to another one says so") {
    const RunWithFrames run(small_spec());
    Trajectory first(run.file());
    const Trajectory second = std::move(first);
    CHECK(second.frames() == 9);
    CHECK_THROWS_AS(first.frames(), InputError);  // NOLINT(bugprone-use-after-move)
    CHECK_THROWS_AS(first.analyze(), InputError);
}

TEST_CASE("a configuration in a file is one that a run can start from") {
    const RunWithFrames run(small_spec());
    const Configuration last = configuration_in(run.folder / "run" / "final.xyz");
    CHECK(last.step.value() == 40);
    CHECK(std::ssize(last.velocities) == atoms_of(run.spec));
    FluidSpec again = run.spec;
    again.start = last;
    CHECK(mistakes(again).empty());
}
