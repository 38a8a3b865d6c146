#include <cmath>
#include <sstream>

#include "io/formats/configuration_reader.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "io/output_fixtures.hpp"
#include "io/three_atoms.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/units.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// A frame is tested in extended_xyz_writer_test.cpp.

namespace {

SubstanceUnits argon() {
    constexpr double boltzmann = 1.380649e-23;
    constexpr double dalton = 1.66053906660e-27;
    return {3.405e-10, 119.8 * boltzmann, 39.948 * dalton};
}

}  // namespace

TEST_CASE("an SI trajectory reads back as the reduced state that it was written from") {
    const TemporaryFolder folder;
    const State state = three_atoms();
    const TrajectoryOptions options{.path = folder / "a.xyz", .velocities = true, .si = argon()};
    make_trajectory_writer("xyz", state, options)->write(state);
    const Configuration read = read_configuration(folder / "a.xyz", argon());
    const auto index_of = state.index_of();
    REQUIRE(read.positions.size() == 3);
    for (std::size_t id = 0; id < 3; ++id) {
        CHECK(read.positions[id].isApprox(state.unwrapped(index_of[id]), 1e-15));
        CHECK(read.velocities[id].isApprox(Vec3(state.velocities().col(index_of[id])), 1e-15));
    }
    CHECK(read.edges.isApprox(state.box().edges(), 1e-15));
    CHECK(read.time == Approx(state.time).epsilon(1e-15));
}

TEST_CASE("SI frames are argon in angstrom, angstrom per picosecond and picoseconds") {
    const TemporaryFolder folder;
    const State state = three_atoms();
    const TrajectoryOptions options{.path = folder / "a.xyz", .velocities = true, .si = argon()};
    make_trajectory_writer("xyz", state, options)->write(state);
    std::istringstream text(content_of(folder / "a.xyz"));
    std::string header;
    std::getline(text, header);
    std::getline(text, header);
    CHECK_THAT(header, Contains("units=si") && Contains("Lattice=\"13.62 0 0 0 17.0"));
    const double tau = 3.405e-10 * std::sqrt(39.948 * 1.66053906660e-27 / (119.8 * 1.380649e-23)) / 1e-12;
    double time = 0.0;
    std::istringstream(header.substr(header.find("Time=") + 5)) >> time;
    CHECK(time == Approx(0.3 * tau).epsilon(1e-14));
    std::string species;
    double x = 0.0;
    double skipped = 0.0;
    double vx = 0.0;
    double px = 0.0;
    text >> species >> x >> skipped >> skipped >> vx >> skipped >> skipped >> px;
    CHECK(species == "Ar");
    CHECK(x == Approx(0.5 * 3.405).epsilon(1e-14));
    CHECK(vx == Approx(1.0 * 3.405 / tau).epsilon(1e-14));
    const double ase_velocity = std::sqrt(1.602176634e-19 / 1.66053906660e-27);  // sqrt(eV/u) [m/s]
    CHECK(px == Approx(39.948 * 100.0 * vx / ase_velocity).epsilon(1e-13));      // 1 angstrom/ps = 100 m/s
}

TEST_CASE("a trajectory holds one frame after the other, each in the file when write returns") {
    const TemporaryFolder folder;
    State state = three_atoms();
    const auto writer = make_trajectory_writer("xyz", state, {.path = folder / "a.xyz"});
    writer->write(state);
    const std::string first = content_of(folder / "a.xyz");
    CHECK_THAT(first, Catch::EndsWith("X 3 3.25 3.5 3\n"));
    state.step = 76;
    writer->write(state);
    const std::string both = content_of(folder / "a.xyz");
    CHECK(both.substr(0, first.size()) == first);
    CHECK_THAT(both.substr(first.size()), Catch::StartsWith("3\n") && Contains("step=76"));
    CHECK_THROWS_AS(writer->write(State(4, Box(Vec3(4.0, 4.0, 4.0)))), ContractViolation);
    CHECK_THROWS_AS(writer->write(State(3)), ContractViolation);
    writer->close();
    writer->close();
    CHECK(content_of(folder / "a.xyz") == both);
}

TEST_CASE("a full disk is an error, and the frames before it stay whole") {
    const TemporaryFolder folder;
    const State state = three_atoms();
    const auto writer = make_trajectory_writer("xyz", state, {.path = folder / "a.xyz"});
    writer->write(state);
    const std::string one = content_of(folder / "a.xyz");
    {
        const FileSizeLimit limit(one.size() + 10);
        CHECK_THROWS_AS(writer->write(state), FileError);
    }
    CHECK_THROWS_AS(writer->write(state), FileError);
    CHECK_THROWS_AS(writer->close(), FileError);
    CHECK(content_of(folder / "a.xyz") == one);
}
