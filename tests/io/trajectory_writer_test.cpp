#include "ljmd/io/trajectory_writer.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// What the formats hold is tested in extended_xyz_writer_test.cpp and h5md_writer_test.cpp; here, what both promise.

namespace {

State sample() {
    State state(3, Box(Vec3(4.0, 5.0, 6.0)));
    for (Index i = 0; i < 3; ++i) {
        state.write_positions().col(i) = Vec3(static_cast<double>(i), 0.5, 0.25);
        state.write_velocities().col(i) = Vec3(0.0, static_cast<double>(i), 0.0);
    }
    state.reorder({2, 0, 1});
    return state;
}

}  // namespace

TEST_CASE("a trajectory file is there at once, in the place of an older one, and writing it leaves the state alone") {
    for (const char* format : {"xyz", "h5md"}) {
        INFO(format);
        const TemporaryFolder folder;
        const auto path = folder / "t";
        std::ofstream(path) << "something else";
        State state = sample();
        const State before = state;
        const auto writer = make_trajectory_writer(format, state, {.path = path, .velocities = true});
        REQUIRE(writer != nullptr);
        CHECK_THAT(content_of(path), !Contains("something else"));
        const auto empty = std::filesystem::file_size(path);
        writer->write(state);
        CHECK(std::filesystem::file_size(path) > empty);
        writer->close();
        CHECK_NOTHROW(writer->close());
        CHECK(folder.count_files() == 1);
        CHECK(state.positions() == before.positions());
        CHECK(state.velocities() == before.velocities());
        CHECK(state.ids() == before.ids());
        CHECK(state.order_version() == before.order_version());
    }
}

TEST_CASE("a trajectory is of one system") {
    for (const char* format : {"xyz", "h5md"}) {
        INFO(format);
        const TemporaryFolder folder;
        const State state = sample();
        const auto writer = make_trajectory_writer(format, state, {.path = folder / "t"});
        CHECK_THROWS_AS(writer->write(State(4, state.box())), ContractViolation);
        CHECK_THROWS_AS(writer->write(State(3)), ContractViolation);
        CHECK_NOTHROW(writer->write(state));
        writer->close();
    }
}

TEST_CASE("a trajectory that cannot be created is an error that names it, a format that there is not is one too") {
    const TemporaryFolder folder;
    for (const char* format : {"xyz", "h5md"}) {
        CHECK_THROWS_AS(make_trajectory_writer(format, sample(), {.path = folder / "none" / "t"}), FileError);
        CHECK_THROWS_WITH(make_trajectory_writer(format, sample(), {.path = folder / "none" / "t"}),
                          Contains("none/t"));
    }
    CHECK_THROWS_AS(make_trajectory_writer("dcd", sample(), {.path = folder / "t"}), InputError);
    CHECK_THROWS_WITH(make_trajectory_writer("", sample(), {.path = folder / "t"}), Contains("'h5md' and 'xyz'"));
    CHECK(folder.count_files() == 0);
}
