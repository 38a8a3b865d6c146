#include "ljmd/io/trajectory_reader.hpp"

#include <catch2/catch.hpp>

#include "io/written_file.hpp"
#include "ljmd/io/trajectory_writer.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using ljmd::test::data_error;
using ljmd::test::WrittenFile;

namespace {

const std::string xyz = "2\nLattice=\"4 0 0 0 5 0 0 0 6\" step=7\nX 1 2 3\nX 2 2 3\n";
const std::string dump =
    "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 4\n0 5\n0 6\n"
    "ITEM: ATOMS id x y z\n2 2 2 3\n1 1 2 3\n";

/// All frames of a file.
struct Read {
    std::vector<Frame> frames;
    std::string warning;
};
Read read_all(const std::filesystem::path& path) {
    const auto reader = open_trajectory(path, std::nullopt);
    Read all;
    Frame frame;
    while (reader->next(frame)) {
        all.frames.push_back(frame);
    }
    CHECK(reader->frames() == std::ssize(all.frames));
    all.warning = reader->warning();
    return all;
}

std::string complaint(const std::string& text) {
    const WrittenFile written(text);
    return data_error([&] { static_cast<void>(read_all(written.path())); });
}

}  // namespace

TEST_CASE("the format of a trajectory is recognised by its content") {
    State state(2, Box(Vec3(4, 5, 6)));
    state.step = 7;
    state.write_positions().col(0) = Vec3(1, 2, 3);
    state.write_positions().col(1) = Vec3(2, 2, 3);
    const WrittenFile h5md("");
    const auto writer = make_trajectory_writer("h5md", state, {.path = h5md.path()});
    writer->write(state);
    writer->close();
    const WrittenFile text(xyz);
    const WrittenFile lammps(dump);
    for (const auto* file : {&h5md, &text, &lammps}) {
        const Read all = read_all(file->path());
        REQUIRE(all.frames.size() == 1);
        const Configuration& found = all.frames[0].configuration;
        CHECK(found.edges == Vec3(4, 5, 6));
        CHECK(found.positions == std::vector<Vec3>{{1, 2, 3}, {2, 2, 3}});
        CHECK(found.velocities.empty());
        CHECK(found.step == 7);
        CHECK(all.frames[0].has_step);
        CHECK(all.warning.empty());
    }
}

TEST_CASE("what is no trajectory is refused") {
    CHECK_THAT(complaint(""), EndsWith("start.txt: the file is empty"));
    CHECK_THAT(complaint("1 2 3\n"), Contains("unknown format; an H5MD file, an extended XYZ file or a LAMMPS dump"));
    CHECK_THAT(data_error([] { static_cast<void>(open_trajectory("nowhere", std::nullopt)); }),
               EndsWith("nowhere: no such file"));
    const WrittenFile written("");
    CHECK_THAT(data_error([&] { static_cast<void>(open_trajectory(written.directory(), std::nullopt)); }),
               Contains("is a directory"));
}

TEST_CASE("the number of atoms stays the same in a trajectory, and steps and times are in all frames or none") {
    const std::string fewer = "1\nLattice=\"4 0 0 0 5 0 0 0 6\"\nX 1 2 3\n";
    const std::string without_step = "2\nLattice=\"4 0 0 0 5 0 0 0 6\"\nX 1 2 3\nX 2 2 3\n";
    const std::string with_time = "2\nLattice=\"4 0 0 0 5 0 0 0 6\" step=8 Time=1\nX 1 2 3\nX 2 2 3\n";
    CHECK_THAT(complaint(xyz + fewer), EndsWith("start.txt:5: frame 2: 1 atoms, but frame 1 has 2"));
    CHECK_THAT(complaint(xyz + without_step), Contains("frame 2: no step, which frame 1 has"));
    CHECK_THAT(complaint(without_step + xyz), Contains("frame 2: a step, which frame 1 has not"));
    CHECK_THAT(complaint(xyz + with_time), Contains("frame 2: a time, which frame 1 has not"));
    CHECK_THAT(complaint(with_time + xyz), Contains("frame 2: no time, which frame 1 has"));
}

TEST_CASE("frames need not all have velocities") {
    const std::string with_velocities =
        "2\nLattice=\"4 0 0 0 5 0 0 0 6\" step=7 Properties=species:S:1:pos:R:3:velo:R:3\nX 1 2 3 0 0 0\nX 2 2 3 0 0 "
        "0\n";
    const WrittenFile written(xyz + with_velocities);
    const Read all = read_all(written.path());
    REQUIRE(all.frames.size() == 2);
    CHECK(all.frames[0].configuration.velocities.empty());
    CHECK(all.frames[1].configuration.velocities.size() == 2);
}

TEST_CASE("only H5MD files have groups of particles") {
    const WrittenFile written(xyz);
    CHECK_THAT(data_error([&] { static_cast<void>(open_trajectory(written.path(), std::nullopt, "solvent")); }),
               Contains("only an H5MD file has groups of particles, such as 'solvent'"));
}

TEST_CASE("of a text that was cut off anywhere the whole frames are read, with a warning") {
    for (const std::string& frame : {xyz, dump}) {
        for (std::size_t kept = 1; kept < frame.size(); ++kept) {
            CAPTURE(kept);
            const WrittenFile written(frame + frame + frame.substr(0, kept));
            const Read all = read_all(written.path());
            CHECK(all.frames.size() == 2);
            CHECK_THAT(all.warning, Contains("frame 3: ") && EndsWith("; the 2 frames before it are used"));
        }
        const WrittenFile whole(frame + frame);
        CHECK(read_all(whole.path()).frames.size() == 2);
        CHECK(read_all(whole.path()).warning.empty());
    }
}

TEST_CASE("a file that ends within its first frame holds nothing") {
    for (const std::string& frame : {xyz, dump}) {
        for (std::size_t kept = 1; kept + 8 < frame.size(); ++kept) {
            CAPTURE(kept);
            CHECK(complaint(frame.substr(0, kept)) != "no DataError");
        }
    }
}

TEST_CASE("damage within a trajectory is an error, not an end") {
    std::string damaged = xyz;
    damaged.replace(damaged.find("X 2"), 3, "X nan");
    CHECK_THAT(complaint(xyz + damaged + xyz), Contains("start.txt:8: frame 2: a coordinate must be a finite number"));
    CHECK_THAT(complaint(xyz + damaged), Contains("start.txt:8: frame 2: "));
    CHECK_THAT(complaint(dump + "ITEM: TIMESTEP\n" + dump), Contains("start.txt:13: frame 2: the step must be"));
    CHECK_THAT(complaint(xyz + "rubbish here\n" + xyz), Contains("start.txt:5: frame 2: expected the number of atoms"));
}
