#include "io/formats/configuration_reader.hpp"

#include <sys/stat.h>

#include <functional>
#include <random>
#include "catch.hpp"

#include "io/formats/trajectory_writer.hpp"
#include "io/gzipped.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::gzipped;
using ljmd::test::WrittenFile;

namespace {

Configuration read(const std::filesystem::path& path) {
    return read_configuration(path, std::nullopt);
}

// The same three atoms in each format. The last number of each file has many digits.
const std::string nist = "10 10 10\n3\n1 1.25 2 3\n2 4 5.5 6\n3 7 8 -9.876543\n";
const std::string lammps =
    "title\n\n3 atoms\n1 atom types\n0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\nMasses\n\n1 1.0\n\nAtoms # atomic\n\n"
    "1 1 1.25 2 3 0 0 0\n2 1 4 5.5 6 0 0 0\n3 1 7 8 0.123457 0 0 -1\n\nVelocities\n\n1 0.25 0 0\n2 0 0.5 0\n3 0 0 "
    "0.765432\n";
const std::string xyz_lattice = "3\nLattice=\"10 0 0 0 10 0 0 0 10\" ";
const std::string xyz = xyz_lattice + "\nX 1.25 2 3\nX 4 5.5 6\nX 7 8 -9.876543\n";
const std::string xyz_with_ids =  // as ljmd writes it
    xyz_lattice +
    "Properties=species:S:1:pos:R:3:velo:R:3:id:I:1 pbc=\"T T T\" Time=0.5 step=100 units=reduced\n"
    "X 1.25 2 3 0.25 0 0 1\nX 4 5.5 6 0 0.5 0 2\nX 7 8 -9.876543 0 0 0.765432 3\n";

/// Equal but for the last number of the file, which a cut may have shortened.
bool equal_but_for(const Configuration& a, const Configuration& b, const std::function<double&(Configuration&)>& last) {
    Configuration left = a;
    Configuration right = b;
    if (left.positions.size() != right.positions.size() || left.velocities.size() != right.velocities.size())
        return false;
    last(left) = 0.0;
    last(right) = 0.0;
    return left.edges == right.edges && left.positions == right.positions && left.velocities == right.velocities &&
           left.masses == right.masses && left.time == right.time && left.step == right.step;
}

double& last_position(Configuration& configuration) {
    return configuration.positions.back()[2];
}
double& last_velocity(Configuration& configuration) {
    return configuration.velocities.back()[2];
}

/// Read every beginning of a good file. What is read must be accepted, the rest must be a DataError.
/// @return how many beginnings were read
int read_beginnings(const std::string& good, const std::function<bool(const Configuration&)>& accepted) {
    const WrittenFile written("");
    int read_count = 0;
    for (std::size_t length = 0; length <= good.size(); ++length) {
        CAPTURE(length);
        written.rewrite(good.substr(0, length));
        try {
            const Configuration configuration = read(written.path());
            CHECK(accepted(configuration));
            ++read_count;
        } catch (const DataError&) {
        }
    }
    return read_count;
}

}  // namespace

TEST_CASE("formats are recognised by content, whatever the name") {
    for (const std::string* text : {&nist, &lammps, &xyz, &xyz_with_ids}) {
        for (const std::string name : {"start.xyz", "start.txt", "data.lammps", "start"}) {
            CAPTURE(*text, name);
            const Configuration configuration = read(WrittenFile(*text, name).path());
            REQUIRE(configuration.positions.size() == 3);
            CHECK(configuration.edges == Vec3(10, 10, 10));
            CHECK(configuration.positions[1] == Vec3(4, 5.5, 6));
            CHECK(configuration.positions[2][2] == Approx(-9.876543).epsilon(1e-12));
        }
    }
    CHECK(read(WrittenFile("three words " + lammps).path()).positions.size() == 3);
    for (const std::string title : {"864\n", "2026 11 25\n", "10 10\n"}) {  // the first line of LAMMPS data
        CHECK(read(WrittenFile(title + lammps.substr(lammps.find('\n') + 1)).path()).velocities.size() == 3);
    }
    for (const std::string comment : {"864 atoms", "864", "0 10 20"}) {  // the second line of extended XYZ
        const WrittenFile written("3\n" + comment + " " + xyz.substr(2));
        CHECK(read(written.path()).positions.size() == 3);
    }
    CHECK(read(WrittenFile(gzipped(xyz_with_ids)).path()).velocities.size() == 3);
    CHECK(read(LJMD_TEST_DATA "/nist/lj_sample_config_periodic4.txt").positions.size() == 30);
}

TEST_CASE("the last frame of an H5MD file is a start, if the file is whole and its atoms are apart") {
    const WrittenFile written("");
    State state(2, Box(Vec3(4, 5, 6)));
    state.write_positions().col(0) = Vec3(1, 2, 3);
    const auto write = [&](double x) {
        const auto writer = make_trajectory_writer("h5md", state, {.path = written.path(), .velocities = true});
        writer->write(state);
        state.step = 9;
        state.write_positions().col(1) = Vec3(x, 2, 3);
        state.write_velocities().col(1) = Vec3(0.5, 0, 0);
        writer->write(state);
        writer->close();
        state.step = 0;
    };
    write(2.0);
    const Configuration last = read(written.path());
    CHECK(last.step == 9);
    CHECK(last.edges == Vec3(4, 5, 6));
    CHECK(last.positions == std::vector<Vec3>{{1, 2, 3}, {2, 2, 3}});
    CHECK(last.velocities[1] == Vec3(0.5, 0, 0));
    std::filesystem::remove(written.path());
    write(5.0);
    CHECK_THAT(data_error([&] { (void)read(written.path()); }), Catch::Contains("atoms 1 and 2 are at the same place"));
}

TEST_CASE("unknown content is refused with the formats that can be read") {
    for (const std::string text : {"\n", "hello\nworld\n", "1 2\n"}) {
        CAPTURE(text);
        const std::string message = data_error([&] { (void)read(WrittenFile(text).path()); });
        CHECK_THAT(message, Catch::Contains("unknown format") && Catch::Contains("NIST") &&
                                Catch::Contains("extended XYZ") && Catch::Contains("LAMMPS data") &&
                                Catch::Contains("H5MD"));
    }
    const std::string wide(
        "\xff\xfe"
        "3\0\n\0",
        6);
    CHECK_THAT(data_error([&] { (void)read(WrittenFile(wide).path()); }), Catch::Contains("UTF-16"));
    const std::string binary("\x89HDF\r\n\x1a\n\0\0\0\0", 12);
    CHECK_THAT(data_error([&] { (void)read(WrittenFile(binary).path()); }), Catch::Contains("HDF5 cannot open it"));
    CHECK_THAT(data_error([&] { (void)read_configuration(WrittenFile(lammps).path(), std::nullopt, "units=si"); }),
               Catch::Contains("is no extended XYZ file, but 'xyz_comment' is given"));
    CHECK_THAT(data_error([&] { (void)read(WrittenFile("").path()); }),
               Catch::Contains("start.txt: the file is empty"));
}

TEST_CASE("what is no regular file is refused at once") {
    const WrittenFile written(nist);
    const std::filesystem::path directory = written.directory();
    CHECK_THAT(data_error([&] { (void)read(directory / "absent"); }), Catch::Contains("absent: no such file"));
    CHECK_THAT(data_error([&] { (void)read(written.path() / "below"); }), Catch::Contains("below: "));
    CHECK_THAT(data_error([&] { (void)read(directory); }), Catch::Contains("is a directory"));
    CHECK_THAT(data_error([&] { (void)read("/dev/zero"); }), Catch::Contains("/dev/zero: is a device"));
    REQUIRE(::mkfifo((directory / "pipe").c_str(), 0600) == 0);
    CHECK_THAT(data_error([&] { (void)read(directory / "pipe"); }), Catch::Contains("pipe: is a pipe"));
    std::filesystem::create_symlink("loop", directory / "loop");
    CHECK_THAT(data_error([&] { (void)read(directory / "loop"); }), Catch::Contains("loop: "));
    std::filesystem::create_symlink(written.path(), directory / "link");
    CHECK(read(directory / "link").positions.size() == 3);
}

// A cut inside the digits of the last number leaves a number, so no reader can see it; nor can it see that whole frames
// or a whole section Velocities are gone. Everything else must be seen. Files with ids in the last column, which ljmd
// writes, have no such blind spot.
TEST_CASE("every beginning of a good file is an error or a right configuration") {
    SECTION("NIST") {
        const Configuration whole = read(WrittenFile(nist).path());
        // "-9", "-9.", ..., "-9.876543", and with its line end
        CHECK(read_beginnings(nist, [&](const Configuration& c) { return equal_but_for(c, whole, last_position); }) ==
              9);
    }
    SECTION("LAMMPS data") {
        const Configuration whole = read(WrittenFile(lammps).path());
        Configuration at_rest = whole;
        at_rest.velocities.clear();
        const auto accepted = [&](const Configuration& c) {
            return c.velocities.empty() ? equal_but_for(c, at_rest, last_position)
                                        : equal_but_for(c, whole, last_velocity);
        };
        // "-1", its line end and a blank line; "0", "0.", ..., "0.765432" and its line end
        CHECK(read_beginnings(lammps, accepted) == 3 + 9);
    }
    SECTION("extended XYZ without ids, two frames") {
        const Configuration whole = read(WrittenFile(xyz).path());
        // In each frame as in NIST.
        CHECK(read_beginnings(xyz + xyz,
                              [&](const Configuration& c) { return equal_but_for(c, whole, last_position); }) == 9 + 9);
    }
    SECTION("extended XYZ with ids in the last column, two frames") {
        const Configuration whole = read(WrittenFile(xyz_with_ids).path());
        const auto accepted = [&](const Configuration& c) {
            return c.velocities == whole.velocities && equal_but_for(c, whole, last_position) &&
                   c.positions == whole.positions;
        };
        CHECK(read_beginnings(xyz_with_ids + xyz_with_ids, accepted) == 4);  // with and without the last line end
    }
}

TEST_CASE("a corrupted byte gives a DataError or finite numbers, never anything else") {
    std::mt19937 random(1967);
    const WrittenFile written("");
    for (const std::string& good : {nist, lammps, xyz + xyz, xyz_with_ids}) {
        for (int trial = 0; trial < 3000; ++trial) {
            std::string bad = good;
            bad[random() % bad.size()] = static_cast<char>(random() % 256);
            CAPTURE(bad);
            written.rewrite(bad);
            try {
                const Configuration configuration = read(written.path());
                REQUIRE(configuration.edges.allFinite());
                REQUIRE(configuration.edges.minCoeff() > 0.0);
                REQUIRE_FALSE(configuration.positions.empty());
                for (const Vec3& position : configuration.positions) REQUIRE(position.allFinite());
                for (const Vec3& velocity : configuration.velocities) REQUIRE(velocity.allFinite());
                if (!configuration.velocities.empty()) {
                    REQUIRE(configuration.velocities.size() == configuration.positions.size());
                }
            } catch (const DataError&) {
            }
        }
    }
}
