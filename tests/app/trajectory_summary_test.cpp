#include "ljmd/app/trajectory_summary.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

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
    CHECK(all.warning.empty());
    const TrajectorySummary some = summary_of(frame("step=5 Time=0.5", 1.0) + frame("step=9", 2.0));
    CHECK(some.steps.size() == 2);
    CHECK(some.times.empty());
}

TEST_CASE("a summary tells where the box changes, and its smallest edges") {
    const TrajectorySummary all =
        summary_of(frame("", 1) + frame("", 1, 4.0 + 1e-7) + frame("", 1, 3.5) + frame("", 1, 5));
    CHECK(all.box_changes == Index{3});
    CHECK(all.edges[0] == 4.0);
    CHECK(all.smallest_edges == Vec3::Constant(3.5));
}

TEST_CASE("positions that spread over more than the box are unwrapped, where the file does not tell") {
    CHECK(summary_of(frame("", 0.1) + frame("", 3.9)).wrapped);
    CHECK(summary_of(frame("", -1.9) + frame("", 1.9)).wrapped);
    CHECK(summary_of(frame("", -0.05) + frame("", 4.05)).wrapped);
    CHECK_FALSE(summary_of(frame("", 0.1) + frame("", 4.6)).wrapped);
    CHECK_FALSE(summary_of(frame("units=reduced", 0.1) + frame("units=reduced", 3.9)).wrapped);
}

TEST_CASE("what the reader has to tell is passed on") {
    const std::string text = frame("", 1.0);
    const TrajectorySummary cut = summary_of(text + text.substr(0, 20));
    CHECK(cut.frames == 1);
    CHECK_THAT(cut.warning, Contains("frame 2: ") && Contains("the 1 frame before it is used"));
    CHECK_THAT(data_error([] { static_cast<void>(summary_of("\n")); }), Contains("unknown format"));
}
