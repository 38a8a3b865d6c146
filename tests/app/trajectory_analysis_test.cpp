#include "ljmd/app/trajectory_analysis.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/run_fixtures.hpp"
#include "io/written_file.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// That what a run has found comes out of its frames again is tested by tests/cli/trajectories.py.

namespace {

/// One atom that goes through the walls of a cube of 4 sigma, by 1.5 sigma from frame to frame.
std::string drifting(bool wrapped, int frames) {
    std::string text;
    for (int k = 0; k < frames; ++k) {
        const double x = 0.25 + 1.5 * k;
        text += fmt::format("2\nLattice=\"4 0 0 0 4 0 0 0 4\" Time={}{}\nX {} 1 1\nX {} 3 1\n", 0.5 * k,
                            wrapped ? "" : " units=reduced", wrapped ? x - 4.0 * std::floor(x / 4.0) : x, 1.0);
    }
    return text;
}

TrajectoryResult analyze(const std::filesystem::path& path, const std::vector<std::string>& names,
                         AnalyzedTrajectory* used = nullptr) {
    AnalyzedTrajectory trajectory{path, nullptr, summarize(path, std::nullopt), {}};
    trajectory.selection = select_frames(trajectory.summary, std::nullopt, nullptr, std::nullopt);
    const auto analyses = make_frame_analyses(names, {}, nullptr, trajectory.summary, trajectory.selection);
    if (used != nullptr) {
        *used = trajectory;
    }
    return analyze_trajectory(trajectory, analyses);
}

}  // namespace

TEST_CASE("displacements go on through the walls, whether the file wraps them or not") {
    for (const bool wrapped : {false, true}) {
        const WrittenFile file(drifting(wrapped, 30));
        const TrajectoryResult result = analyze(file.path(), {"msd"});
        REQUIRE(result.tables.size() == 1);
        const auto& rows = result.tables[0].rows;
        REQUIRE(rows.size() > 2);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const auto lag = static_cast<double>(k);
            CHECK(rows[k][0] == Approx(0.5 * lag));
            CHECK(rows[k][1] == Approx(0.5 * 2.25 * lag * lag));  // one of two atoms moves
        }
        const auto said = [](const std::string& text) { return text.find("nearest images") != std::string::npos; };
        CHECK(std::ranges::count_if(result.warnings, said) == (wrapped ? 1 : 0));
    }
}

TEST_CASE("an analysis that has too few frames says so") {
    const WrittenFile file(drifting(true, 2));
    const TrajectoryResult result = analyze(file.path(), {"rdf", "msd"});
    CHECK(result.tables.size() == 2);
    CHECK_THAT(result.warnings.at(1), Contains("msd has found nothing: 2 frames are too few"));
}

TEST_CASE("a trajectory is reported to people and to programs") {
    const WrittenFile file(drifting(false, 30));
    AnalyzedTrajectory trajectory;
    const TrajectoryResult result = analyze(file.path(), {"msd"}, &trajectory);
    const std::string table = trajectory_table(trajectory, result);
    CHECK_THAT(table, Contains("30 frames of 2 atoms, box 4 x 4 x 4 sigma^3\n30 measured, 0.5 tau apart\n"));
    CHECK_THAT(table, Contains("diffusion                 D"));
    const auto json = nlohmann::json::parse(trajectory_json(trajectory, result));
    CHECK(json.at("frames") == 30);
    CHECK(json.at("frames_used") == 30);
    CHECK(json.at("atoms") == 2);
    CHECK(json.at("spacing") == 0.5);
    CHECK(json.at("observables").at("diffusion").at("unit") == "sigma^2/tau");
    CHECK(json.at("warnings").size() == result.warnings.size());
}

TEST_CASE("a file that changes while it is read is noticed") {
    const WrittenFile file(drifting(false, 30));
    AnalyzedTrajectory trajectory;
    static_cast<void>(analyze(file.path(), {"msd"}, &trajectory));
    file.rewrite(drifting(false, 29));
    const auto analyses = make_frame_analyses({"rdf"}, {}, nullptr, trajectory.summary, trajectory.selection);
    CHECK_THROWS_WITH(analyze_trajectory(trajectory, analyses), Contains("has changed while it was read"));
}
