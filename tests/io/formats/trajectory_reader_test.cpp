#include "io/formats/trajectory_reader.hpp"

#include <fmt/format.h>
#include "catch.hpp"

#include "io/formats/trajectory_writer.hpp"
#include "io/gzipped.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using ljmd::test::data_error;
using ljmd::test::gzipped;
using ljmd::test::WrittenFile;

namespace {

const std::string xyz = "2\nLattice=\"4 0 0 0 5 0 0 0 6\" step=7\nX 1 2 3\nX 2 2 3\n";
const std::string dump =
    "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 4\n0 5\n0 6\n"
    "ITEM: ATOMS id x y z\n2 2 2 3\n1 1 2 3\n";

/// All frames of a file.
struct Read {
    std::vector<Frame> frames;
    Index read = 0;
    std::vector<std::string> warnings;
    std::string warning;  ///< the first
};
Read read_all(const std::filesystem::path& path) {
    const auto reader = open_trajectory(path, std::nullopt);
    Read all;
    Frame frame;
    while (reader->next(frame)) {
        all.frames.push_back(frame);
    }
    all.read = reader->frames();
    all.warnings = reader->warnings();
    all.warning = all.warnings.empty() ? "" : all.warnings[0];
    return all;
}

/// A frame at another step than 7, moved along x.
std::string later(const std::string& frame, int step, double moved = 0.0) {
    const auto with = [&](std::string text, const std::string& part, const std::string& instead) {
        return text.replace(text.find(part), part.size(), instead);
    };
    const std::string shifted = with(frame, "1 2 3", fmt::format("{} 2 3", 1.0 + moved));
    return frame == xyz ? with(shifted, "step=7", fmt::format("step={}", step))
                        : with(shifted, "\n7\n", fmt::format("\n{}\n", step));
}

std::vector<Index> steps_of(const Read& read) {
    std::vector<Index> steps;
    for (const Frame& frame : read.frames) {
        steps.push_back(frame.configuration.step.value());
    }
    return steps;
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
        CHECK(all.frames[0].configuration.step);
        CHECK(all.warning.empty());
    }
}

TEST_CASE("what is no trajectory is refused") {
    CHECK_THAT(complaint(""), EndsWith("start.txt: the file is empty"));
    CHECK_THAT(complaint("1 2 3\n"), Contains("unknown format; an H5MD file, a LAMMPS dump or an extended XYZ file"));
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
        "2\nLattice=\"4 0 0 0 5 0 0 0 6\" step=8 Properties=species:S:1:pos:R:3:velo:R:3\nX 1 2 3 0 0 0\nX 2 2 3 0 0 "
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
            const WrittenFile written(frame + later(frame, 8) + later(frame, 9).substr(0, kept));
            const Read all = read_all(written.path());
            CHECK(all.frames.size() == 2);
            CHECK_THAT(all.warning, Contains("frame 3: ") && EndsWith("; the 2 frames before it are used"));
        }
        const WrittenFile whole(frame + later(frame, 8));
        CHECK(read_all(whole.path()).frames.size() == 2);
        CHECK(read_all(whole.path()).warning.empty());
    }
}

TEST_CASE("where a run was appended to another one, each step is counted once") {
    for (const std::string& frame : {xyz, dump}) {
        const std::string first = later(frame, 0, 0.0) + later(frame, 10, 0.5) + later(frame, 20, 1.0);
        const WrittenFile repeated(first + later(frame, 20, 1.0) + later(frame, 30, 1.5));
        const Read one = read_all(repeated.path());
        CHECK(steps_of(one) == std::vector<Index>{0, 10, 20, 30});
        CHECK(one.read == 5);
        CHECK_FALSE(one.frames[3].begins_anew);  // the repeated frame is the one before it
        REQUIRE(one.warnings.size() == 1);
        CHECK_THAT(one.warning, Contains("1 frame, frame 4, repeats a step") && Contains("counted once"));

        const WrittenFile back(first + later(frame, 10, 0.5) + later(frame, 20, 1.3) + later(frame, 30, 1.5));
        const Read other = read_all(back.path());
        CHECK(steps_of(other) == std::vector<Index>{0, 10, 20, 30});
        CHECK(other.frames[3].begins_anew);  // another trajectory from the same step
        CHECK_THAT(other.warning, Contains("2 frames, the first of them frame 4, repeat steps") && Contains("gap"));
    }
}

TEST_CASE("without steps times tell which frames come again, and without both none do") {
    const auto timed = [](double time) {
        return fmt::format("2\nLattice=\"4 0 0 0 5 0 0 0 6\" Time={}\nX 1 2 3\nX 2 2 3\n", time);
    };
    const WrittenFile times(timed(0) + timed(0.5) + timed(0.5) + timed(1));
    CHECK(read_all(times.path()).frames.size() == 3);
    const std::string plain = "2\nLattice=\"4 0 0 0 5 0 0 0 6\"\nX 1 2 3\nX 2 2 3\n";
    const WrittenFile untold(plain + plain);
    CHECK(read_all(untold.path()).frames.size() == 2);
}

TEST_CASE("a compressed trajectory is read like any other, and as far as it goes when it was cut off") {
    for (const std::string& frame : {xyz, dump}) {
        const std::string packed = gzipped(frame) + gzipped(later(frame, 8));
        const WrittenFile whole(packed);
        CHECK(steps_of(read_all(whole.path())) == std::vector<Index>{7, 8});
        const WrittenFile cut(packed.substr(0, packed.size() - 20));
        const Read found = read_all(cut.path());
        CHECK(steps_of(found) == std::vector<Index>{7});
        CHECK_THAT(found.warning, Contains("the gzip file is cut off") && EndsWith("the 1 frame before it is used"));
    }
}

TEST_CASE("a comment beside the file is for extended XYZ alone") {
    const WrittenFile written(dump);
    CHECK_THAT(data_error([&] { static_cast<void>(open_trajectory(written.path(), std::nullopt, "", "units=si")); }),
               Contains("is no extended XYZ file, but --xyz-comment is given"));
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
    CHECK_THAT(complaint(gzipped(xyz + damaged)), Contains("start.txt:8: frame 2: "));
    CHECK_THAT(complaint(dump + "ITEM: TIMESTEP\n" + dump), Contains("start.txt:13: frame 2: the step must be"));
    CHECK_THAT(complaint(xyz + "rubbish here\n" + xyz), Contains("start.txt:5: frame 2: expected the number of atoms"));
}
