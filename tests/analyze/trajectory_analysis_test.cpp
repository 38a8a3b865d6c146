#include "analyze/trajectory_analysis.hpp"

#include <fmt/format.h>

#include "io/written_file.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// That what a run has found comes out of its frames again is tested by tests/cli/trajectories.py.

namespace {

/// How a file has the positions of an atom that leaves the box.
enum class Written { unwrapped, wrapped, wrapped_late };

/// One atom of two that goes through the walls of a cube of 4 sigma, by 0.75 sigma from frame to frame: half as far
/// from the centre of mass, as the other one does.
std::string drifting(Written how, int frames, const std::string& keys = "") {
    std::string text;
    double edges = 0.0;
    for (int k = 0; k < frames; ++k) {
        const double x = 0.25 + 0.75 * k;
        // Programs that wrap late do so when they build lists: here every 3 frames.
        if (how == Written::wrapped || (how == Written::wrapped_late && k % 3 == 0)) {
            edges = std::floor(x / 4.0);
        }
        text += fmt::format("2\nLattice=\"4 0 0 0 4 0 0 0 4\" Time={} {}\nX {} 1 1\nX {} 3 1\n", 0.5 * k, keys,
                            x - 4.0 * edges, 1.0);
    }
    return text;
}

TrajectoryResult analyze(const std::filesystem::path& path, const std::vector<std::string>& names,
                         AnalyzedTrajectory* used = nullptr, std::optional<Positions> said = std::nullopt,
                         const Deck* deck = nullptr) {
    AnalyzedTrajectory trajectory{path, deck, summarize(path, std::nullopt, {}, said), {}};
    trajectory.selection = select_frames(trajectory.summary, std::nullopt, nullptr, std::nullopt);
    const auto analyses = make_frame_analyses(names, {}, deck, trajectory.summary, trajectory.selection);
    if (used != nullptr) {
        *used = trajectory;
    }
    return analyze_trajectory(trajectory, analyses);
}

}  // namespace

TEST_CASE("displacements go on through the walls, however the file wraps positions") {
    for (const Written how : {Written::unwrapped, Written::wrapped, Written::wrapped_late}) {
        const WrittenFile file(drifting(how, 30));
        AnalyzedTrajectory trajectory;
        const TrajectoryResult result = analyze(file.path(), {"msd"}, &trajectory);
        REQUIRE(result.tables.size() == 1);
        const auto& rows = result.tables[0].rows;
        REQUIRE(rows.size() > 2);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const auto lag = static_cast<double>(k);
            CHECK(rows[k][0] == Approx(0.5 * lag));
            CHECK(rows[k][1] == Approx(0.375 * 0.375 * lag * lag));
        }
        CHECK(result.used_displacements);
        const bool unwrapped = how == Written::unwrapped;
        CHECK_THAT(trajectory_document(trajectory, result).text,
                   Contains(unwrapped ? "\npositions: unwrapped (no atom moves by more than half an edge"
                                      : "\npositions: wrapped, atoms followed by their nearest images, at most 0.19 "
                                        "edges away (told by displacements)\n"));
        const auto json = trajectory_document(trajectory, result).data;
        CHECK(json.at("positions").at("taken_as") == (unwrapped ? "unwrapped" : "wrapped"));
        CHECK(json.at("positions").at("told_by") == "displacements");
        CHECK(json.at("positions").at("largest_step").number() == Approx(0.75 / 4.0));
    }
}

TEST_CASE("units in a file are no proof that its positions are unwrapped") {
    const WrittenFile file(drifting(Written::wrapped, 30, "units=reduced"));
    CHECK(analyze(file.path(), {"msd"}).tables.at(0).rows.at(6)[1] == Approx(0.25 * 20.25));
}

TEST_CASE("a file that says unwrapped, but whose atoms jump by edges, is followed, and the contradiction told") {
    const WrittenFile file(drifting(Written::wrapped, 30, "positions=unwrapped"));
    const TrajectoryResult result = analyze(file.path(), {"msd"});
    CHECK(result.tables.at(0).rows.at(6)[1] == Approx(0.25 * 20.25));
    CHECK_THAT(result.warnings.at(0), Contains("the file says that positions are unwrapped, but they are wrapped"));
}

TEST_CASE("where nothing tells whether positions are wrapped, displacements want to be told") {
    std::string text;
    for (int k = 0; k < 20; ++k) {
        text += fmt::format("2\nLattice=\"4 0 0 0 4 0 0 0 4\" Time={}\nX {} 1 1\nX 1 3 1\n", k,
                            std::fmod(0.25 + 1.5 * k, 4.0));
    }
    const WrittenFile file(text);
    CHECK_THROWS_WITH(analyze(file.path(), {"msd"}),
                      Contains("msd needs displacements: neither the file nor the displacements tell whether") &&
                          Contains("--positions wrapped") && Contains("--positions unwrapped"));
    CHECK(analyze(file.path(), {"rdf"}).tables.size() == 2);
    const TrajectoryResult wrapped = analyze(file.path(), {"msd"}, nullptr, Positions::wrapped);
    CHECK(wrapped.tables.at(0).rows.at(2)[1] == Approx(0.25 * 9.0));
    CHECK_THAT(wrapped.warnings.at(0), Contains("--positions wrapped: from frame to frame atoms move by up to 0.38"));
    const TrajectoryResult unwrapped = analyze(file.path(), {"msd"}, nullptr, Positions::unwrapped);
    CHECK(unwrapped.tables.at(0).rows.at(2)[1] < 0.25 * 9.0);
}

TEST_CASE("frames of a run under an external force have no diffusion, because they do not tell what the force was") {
    const WrittenFile file(drifting(Written::unwrapped, 30));
    const DeckFolder folder;
    Deck deck = folder.load();
    const auto diffusion = [&] {
        const TrajectoryResult result = analyze(file.path(), {"msd"}, nullptr, std::nullopt, &deck);
        const auto found = std::ranges::find(result.averages, "diffusion", &ObservableAverage::name);
        REQUIRE(found != result.averages.end());
        return *found;
    };
    CHECK(diffusion().estimate.has_value());
    deck.given.external = "wave";
    CHECK_FALSE(diffusion().estimate.has_value());
    CHECK_THAT(diffusion().remark, Contains("do not tell whether the external force 'wave' differed between atoms"));
}

TEST_CASE("an analysis that has too few frames says so") {
    const WrittenFile file(drifting(Written::wrapped, 2));
    const TrajectoryResult result = analyze(file.path(), {"rdf", "msd"});
    CHECK(result.tables.size() == 2);
    CHECK_THAT(result.warnings.at(0), Contains("msd has found nothing: 2 frames are too few"));
}

TEST_CASE("a trajectory is reported to people and to programs") {
    const WrittenFile file(drifting(Written::unwrapped, 30));
    AnalyzedTrajectory trajectory;
    const TrajectoryResult result = analyze(file.path(), {"msd"}, &trajectory);
    const std::string table = trajectory_document(trajectory, result).text;
    CHECK_THAT(table, Contains("30 frames of 2 atoms, box 4 x 4 x 4 sigma^3\n30 measured, 0.5 tau apart\n"));
    CHECK_THAT(table, Contains("  diffusion               D  "));
    const auto json = trajectory_document(trajectory, result).data;
    CHECK(json.at("frames") == 30);
    CHECK(json.at("frames_used") == 30);
    CHECK(json.at("atoms") == 2);
    CHECK(json.at("spacing") == 0.5);
    CHECK(json.at("observables").at("diffusion").at("unit") == "sigma^2/tau");
    CHECK(json.at("warnings").size() == result.warnings.size());
}

TEST_CASE("a file that changes while it is read is noticed") {
    const WrittenFile file(drifting(Written::unwrapped, 30));
    AnalyzedTrajectory trajectory;
    static_cast<void>(analyze(file.path(), {"msd"}, &trajectory));
    file.rewrite(drifting(Written::unwrapped, 29));
    const auto analyses = make_frame_analyses({"rdf"}, {}, nullptr, trajectory.summary, trajectory.selection);
    CHECK_THROWS_WITH(analyze_trajectory(trajectory, analyses), Contains("has changed while it was read"));
}
