#include "analyze/trajectory_summary.hpp"

#include <fmt/format.h>
#include "catch.hpp"

#include "io/written_file.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using ljmd::test::data_error;
using ljmd::test::WrittenFile;

namespace {

/// A frame of one atom in a cube.
std::string frame(const std::string& keys, double x, double edge = 4.0) {
    return fmt::format("1\nLattice=\"{0} 0 0 0 {0} 0 0 0 {0}\" {1}\nX {2} 1 1\n", edge, keys, x);
}

TrajectorySummary summary_of(const std::string& text) {
    const WrittenFile written(text);
    return summarize(written.path(), std::nullopt);
}

}  // namespace

TEST_CASE("a summary tells what all frames have") {
    const TrajectorySummary all = summary_of(frame("step=5 Time=0.5", 1.0) + frame("step=9 Time=0.75", 2.0));
    CHECK(all.frames == 2);
    CHECK(all.atoms == 1);
    CHECK(all.edges == Vec3::Constant(4.0));
    CHECK(all.steps == std::vector<Index>{5, 9});
    CHECK(all.times == std::vector<double>{0.5, 0.75});
    CHECK_FALSE(all.has_velocities);
    CHECK_FALSE(all.box_changes.has_value());
    CHECK(all.warnings.empty());
    const TrajectorySummary some = summary_of(frame("step=5", 1.0) + frame("step=9", 2.0));
    CHECK(some.steps.size() == 2);
    CHECK(some.times.empty());
}

TEST_CASE("a summary tells whether all frames have velocities, and why not") {
    const std::string without = frame("", 1.0);
    const std::string with_velocities =
        "1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3:velo:R:3\nX 1 1 1 0 0 1\n";
    CHECK(summary_of(with_velocities + with_velocities).has_velocities);
    CHECK_FALSE(summary_of(without).has_velocities);
    CHECK(summary_of(without).missing_velocities == "which the trajectory does not have");
    CHECK_FALSE(summary_of(with_velocities + without + without).has_velocities);
    CHECK(summary_of(with_velocities + without + without).missing_velocities == "which frame 2 does not have");
    CHECK(summary_of(without + with_velocities).missing_velocities == "which frame 1 does not have");
}

TEST_CASE("a summary tells whether ids name other atoms than those of the frames") {
    const auto is_part = [](const std::string& ids) {
        std::string rows;
        for (const char id : ids) {
            rows += fmt::format("X {0} 1 1 {0}\n", id);
        }
        return summary_of(fmt::format("{}\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3:id:I:1\n{}",
                                      ids.size(), rows))
            .is_part;
    };
    CHECK_FALSE(is_part("123"));
    CHECK_FALSE(is_part("201"));
    CHECK_FALSE(is_part("1"));
    CHECK(is_part("124"));
    CHECK(is_part("013"));
    CHECK(is_part("234"));
    CHECK_FALSE(summary_of(frame("", 1.0)).is_part);
}

TEST_CASE("a summary tells where the box changes, and its smallest edges") {
    const TrajectorySummary all =
        summary_of(frame("", 1) + frame("", 1, 4.0 + 1e-7) + frame("", 1, 3.5) + frame("", 1, 5));
    CHECK(all.box_changes == Index{3});
    CHECK(all.edges[0] == 4.0);
    CHECK(all.smallest_edges == Vec3::Constant(3.5));
}

TEST_CASE("displacements tell whether positions are wrapped, and a file does where all its frames say so") {
    const std::string told = "positions=unwrapped";
    const auto positions = [](const std::string& text) { return summary_of(text).positions.positions; };
    CHECK(positions(frame("", 0.1) + frame("", 3.9)) == Positions::wrapped);
    CHECK(positions(frame("units=reduced", 0.1) + frame("units=reduced", 3.9)) == Positions::wrapped);
    CHECK(positions(frame("", 0.1) + frame("", 1.9)) == Positions::unwrapped);
    CHECK(positions(frame("", 0.1) + frame("", 2.9)) == std::nullopt);
    CHECK(positions(frame(told, 0.1) + frame("", 2.9)) == std::nullopt);
    CHECK(positions(frame(told, 0.1) + frame(told, 2.9)) == Positions::unwrapped);
    const WrittenFile written(frame("", 0.1) + frame("", 2.9));
    const TrajectorySummary said = summarize(written.path(), std::nullopt, {}, Positions::wrapped);
    CHECK(said.positions.positions == Positions::wrapped);
    CHECK(said.motion.jumps == 1);
    CHECK(said.motion.largest_step == Approx(0.3));
}

TEST_CASE("a summary tells where a file was joined from runs that do not go on from each other") {
    const TrajectorySummary all = summary_of(frame("step=0", 1.0) + frame("step=1", 1.1) + frame("step=1", 3.1) +
                                             frame("step=2", 3.0) + frame("step=3", 2.9));
    CHECK(all.steps == std::vector<Index>{0, 1, 2, 3});
    CHECK(all.breaks == std::vector<std::size_t>{2});
    CHECK(all.warnings.size() == 1);
}

TEST_CASE("what the reader has to tell is passed on") {
    const std::string text = frame("", 1.0);
    const TrajectorySummary cut = summary_of(text + text.substr(0, 20));
    CHECK(cut.frames == 1);
    REQUIRE(cut.warnings.size() == 1);
    CHECK_THAT(cut.warnings[0], Contains("frame 2: ") && Contains("the 1 frame before it is used"));
    CHECK_THAT(data_error([] { static_cast<void>(summary_of("\n")); }), Contains("unknown format"));
}
