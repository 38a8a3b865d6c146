#include "io/formats/extended_xyz_writer.hpp"

#include <cmath>
#include <sstream>

#include "io/formats/configuration_reader.hpp"
#include "io/output_fixtures.hpp"
#include "io/three_atoms.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("an extended XYZ frame is written to the letter, atoms by id and unwrapped") {
    const TemporaryFolder folder;
    write_configuration(folder / "final.xyz", three_atoms(), true);
    CHECK(content_of(folder / "final.xyz") ==
          "3\n"
          "Lattice=\"4 0 0 0 5 0 0 0 6.5\" Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3:id:I:1 pbc=\"T T T\" "
          "Time=0.3 step=75 units=reduced positions=unwrapped\n"
          "X 0.5 1 1.5 1 0 -1 1 0 -1 1\n"
          "X -1.25 5.5 13.75 0.1 0.2 0.3 0.1 0.2 0.3 2\n"
          "X 3 3.25 3.5 1e-05 -25000000000 0 1e-05 -25000000000 0 3\n");
}

TEST_CASE("velocities are optional, and without a box there is no lattice") {
    const TemporaryFolder folder;
    write_configuration(folder / "final.xyz", three_atoms(std::nullopt), false);
    CHECK(content_of(folder / "final.xyz") ==
          "3\n"
          "Properties=species:S:1:pos:R:3:id:I:1 pbc=\"F F F\" Time=0.3 step=75 units=reduced positions=unwrapped\n"
          "X 0.5 1 1.5 1\n"
          "X -1.25 5.5 13.75 2\n"
          "X 3 3.25 3.5 3\n");
}

TEST_CASE("numbers read back to the same double") {
    const TemporaryFolder folder;
    State state(2, Box(Vec3(10.0 / 3.0, 10.0 / 7.0, 1e3 / 17.0)));
    for (int a = 0; a < 3; ++a) {
        state.write_positions()(a, 0) = state.snapped(Vec3::Constant(std::sqrt(a + 2.0)))[a];
        state.write_velocities()(a, 1) = std::exp(-40.0 * a) / 3.0;
    }
    write_configuration(folder / "a.xyz", state, true);
    std::istringstream text(content_of(folder / "a.xyz"));
    std::string line;
    std::getline(text, line);
    std::getline(text, line);
    for (Index i = 0; i < 2; ++i) {
        std::string species;
        Vec3 r;
        Vec3 v;
        text >> species >> r[0] >> r[1] >> r[2] >> v[0] >> v[1] >> v[2];
        std::getline(text, line);
        CHECK(r == Vec3(state.positions().col(i)));
        CHECK(v == Vec3(state.velocities().col(i)));
    }
    for (int a = 0; a < 3; ++a) {
        const double edge = state.box().edges()[a];
        const std::string lattice = content_of(folder / "a.xyz").substr(11);
        std::istringstream numbers(lattice);
        double number = 0.0;
        for (int k = 0; k <= 4 * a; ++k) {
            numbers >> number;
        }
        CHECK(number == edge);
    }
}

TEST_CASE("a later run starts from exactly the same configuration") {
    const TemporaryFolder folder;
    State state = three_atoms(Box(Vec3(10.0 / 3.0, 10.0 / 7.0, 1e3 / 17.0)));
    state.write_velocities().col(0) = Vec3(1.0 / 3.0, -std::sqrt(2.0), 1e-300);
    write_configuration(folder / "final.xyz", state, true);
    const Configuration read = read_configuration(folder / "final.xyz", std::nullopt);
    CHECK(read.edges == state.box().edges());
    CHECK(read.time == state.time);
    CHECK(read.step == state.step);
    const auto index_of = state.index_of();
    REQUIRE(read.positions.size() == 3);
    REQUIRE(read.velocities.size() == 3);
    for (std::size_t id = 0; id < 3; ++id) {
        CHECK(read.positions[id] == state.unwrapped(index_of[id]));
        CHECK(read.velocities[id] == Vec3(state.velocities().col(index_of[id])));
    }
}

TEST_CASE("a final configuration that cannot be written leaves the old one and nothing else") {
    const TemporaryFolder folder;
    const auto path = folder / "final.xyz";
    write_configuration(path, three_atoms(), true);
    const std::string old = content_of(path);
    State large(1000, Box(Vec3(9.0, 9.0, 9.0)));
    {
        const FileSizeLimit limit(2000);
        CHECK_THROWS_AS(write_configuration(path, large, true), FileError);
    }
    CHECK(content_of(path) == old);
    CHECK(folder.count_files() == 1);
    write_configuration(path, large, true);
    CHECK_THAT(content_of(path), Catch::StartsWith("1000\n"));
}
