#include "io/formats/lammps_dump.hpp"

#include <fmt/format.h>
#include "catch.hpp"

#include "io/written_file.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using ljmd::test::data_error;
using ljmd::test::Malformed;
using ljmd::test::WrittenFile;

namespace {

const std::string head = "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n-1 3\n0 5\n2 8\n";
const std::string frame = head + "ITEM: ATOMS id xu yu zu \n2 1 2 3 \n1 0.25 -1 2e-3\n";

/// The only frame of a dump.
Frame read_text(const std::string& text) {
    const WrittenFile written(text);
    LammpsDumpTrajectory reader(written.path());
    Frame found;
    const bool there = reader.next(found);
    REQUIRE(there);
    return found;
}

/// The frame with tilt factors xy, xz, yz.
std::string tilted(const std::string& factors) {
    std::vector<std::string_view> f;
    split_fields(factors, f);
    return fmt::format(
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n-1 3 {}\n0 5 {}\n2 8 {}\n"
        "ITEM: ATOMS id xu yu zu\n1 0 2 5\n2 5 -3 6\n",
        f[0], f[1], f[2]);
}

std::string with(std::string text, const std::string& part, const std::string& instead) {
    REQUIRE(text.find(part) != std::string::npos);
    return text.replace(text.find(part), part.size(), instead);
}

}  // namespace

TEST_CASE("a dump is read frame by frame, atoms in the order of ids") {
    const WrittenFile written(frame + with(frame, "\n7\n", "\n9\n"));
    LammpsDump dump(written.path());
    REQUIRE(dump.next_frame(2));
    CHECK(dump.step() == 7);
    CHECK(dump.atoms() == 2);
    CHECK(dump.low() == Vec3(-1, 0, 2));
    CHECK(dump.edges() == Vec3(4, 5, 6));
    CHECK(dump.has("zu"));
    CHECK_FALSE(dump.has("z"));
    LammpsDump::Rows expected(2, 2);
    expected << 2e-3, 0.25, 3.0, 1.0;
    CHECK(dump.read_atoms({"zu", "xu"}) == expected);
    CHECK(dump.order().rows == std::vector<Index>{1, 0});
    REQUIRE(dump.next_frame());
    CHECK(dump.step() == 9);
    static_cast<void>(dump.read_atoms({"xu"}));
    CHECK_FALSE(dump.next_frame());
}

TEST_CASE("positions of a dump are unwrapped, scaled or wrapped, from the corner of the box") {
    const auto positions = [](const std::string& columns, const std::string& atoms) {
        const Frame found = read_text(head + "ITEM: ATOMS " + columns + "\n" + atoms);
        return std::pair(found.configuration.positions, found.configuration.is_unwrapped);
    };
    const std::vector<Vec3> expected{{1, 2, 3}, {6, -3, 4}};
    CHECK(positions("id xu yu zu", "1 0 2 5\n2 5 -3 6\n") == std::pair(expected, true));
    CHECK(positions("zu id yu xu", "5 1 2 0\n6 2 -3 5\n") == std::pair(expected, true));
    CHECK(positions("id xsu ysu zsu", "1 0.25 0.4 0.5\n2 1.5 -0.6 0.66666666666666663\n").second);
    CHECK(positions("id xsu ysu zsu", "1 0.25 0.4 0.5\n2 1.5 -0.6 0.75\n").first ==
          std::vector<Vec3>{{1, 2, 3}, {6, -3, 4.5}});
    CHECK(positions("id type x y z ix iy iz", "2 1 1 2 6 1 -1 0\n1 1 0 2 5 0 0 0\n") == std::pair(expected, true));
    CHECK(positions("id x y z", "1 0 2 5\n2 1 2 6\n") == std::pair(std::vector<Vec3>{{1, 2, 3}, {2, 2, 4}}, false));
    CHECK(positions("id xs ys zs", "1 0.25 0.4 0.5\n2 0.5 0.4 0.5\n") ==
          std::pair(std::vector<Vec3>{{1, 2, 3}, {2, 2, 3}}, false));
    CHECK(positions("id x y z xu yu zu", "1 9 9 9 0 2 5\n2 9 9 9 5 -3 6\n").first == expected);
}

TEST_CASE("a dump may tell its units, its times and velocities") {
    const Frame found = read_text("ITEM: UNITS\nlj\nITEM: TIME\n0.035\n" + head +
                                  "ITEM: ATOMS id element x y z vx vy vz\n2 Ar 0 1 3 4 5 6\n1 Ar 0 0 3 1 2 3\n");
    CHECK(found.configuration.time);
    CHECK(found.configuration.time == 0.035);
    CHECK(found.configuration.velocities == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    CHECK_FALSE(read_text(frame).configuration.time);
    CHECK(read_text(frame).configuration.velocities.empty());
}

TEST_CASE("a dump whose tilt factors are zero, or of rounding, has an orthogonal box") {
    for (const std::string factors : {"0 0 0", "-0.0 0.0 0", "1.6e-15 0 -2e-15"}) {
        CAPTURE(factors);
        const Frame found = read_text(tilted(factors));
        CHECK(found.configuration.edges == Vec3(4, 5, 6));
        CHECK(found.configuration.positions == std::vector<Vec3>{{1, 2, 3}, {6, -3, 4}});
    }
}

TEST_CASE("a box whose boundaries are not told is taken as periodic, with a word") {
    const WrittenFile written(with(frame, " pp pp pp", "") + with(with(frame, "\n7\n", "\n8\n"), " pp pp pp", ""));
    LammpsDumpTrajectory reader(written.path());
    Frame found;
    REQUIRE(reader.next(found));
    REQUIRE(reader.next(found));
    CHECK(found.configuration.edges == Vec3(4, 5, 6));
    REQUIRE(reader.warnings().size() == 1);
    CHECK_THAT(reader.warnings()[0], Contains("does not tell the boundaries: the box is taken as periodic"));
}

TEST_CASE("the dump of a group has ids with gaps, the same in all frames") {
    const std::string group = head + "ITEM: ATOMS id xu yu zu\n900 1 2 3\n7 0 1 3\n";
    const std::string next = with(group, "\n7\n", "\n8\n");
    const WrittenFile written(group + next);
    LammpsDumpTrajectory reader(written.path());
    Frame found;
    REQUIRE(reader.next(found));
    CHECK(found.ids == std::vector<Index>{7, 900});
    CHECK(found.configuration.positions == std::vector<Vec3>{{1, 1, 1}, {2, 2, 1}});
    REQUIRE(reader.next(found));
    const WrittenFile others(group + with(next, "900", "901"));
    LammpsDumpTrajectory other(others.path());
    REQUIRE(other.next(found));
    CHECK_THAT(data_error([&] { static_cast<void>(other.next(found)); }),
               Contains("start.txt:22: frame 2: other atoms than in frame 1: id 901, where that has id 900"));
}

TEST_CASE("a general triclinic box along the axes is an orthogonal one") {
    const Frame found = read_text(
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n"
        "4 0 0 -1\n0 5 0 2\n0 0 6 0\nITEM: ATOMS id x y z q fx fy fz\n1 0 3 1 -0.5 nan nan nan\n");
    CHECK(found.configuration.edges == Vec3(4, 5, 6));
    CHECK(found.configuration.positions == std::vector<Vec3>{{1, 1, 1}});
    REQUIRE(found.configuration.remarks.size() == 1);
    CHECK_THAT(found.configuration.remarks[0], Contains("the atoms have charges ('q'), which are not taken"));
}

TEST_CASE("a dump that cannot be used is refused, with its line") {
    const std::vector<Malformed> cases{
        {2, "the step must be an integer", with(frame, "\n7\n", "\nx\n")},
        {9, "a step that is not negative", with(frame, "\n7\n", "\n-7\n")},
        {4, "the number of atoms must be at least 1", with(frame, "\n2\nITEM", "\n0\nITEM")},
        {4, "the file announces 3000 atoms", with(frame, "\n2\nITEM", "\n3000\nITEM")},
        {5, "the box must be periodic", with(frame, "pp pp pp", "pp ff pp")},
        {6, "two bounds of the box and a tilt factor were expected", with(frame, "pp pp pp", "xy xz yz pp pp pp")},
        {5, "the box is tilted", tilted("0 1e-9 0")},
        {6, "a tilt factor must be a finite number", tilted("nan 0 0")},
        {6, "a vector of the box and a coordinate of its corner", with(frame, "pp pp pp", "abc origin pp pp pp")},
        {5, "not along the axes",
         "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n"
         "4 0.1 0 0\n0 5 0 0\n0 0 6 0\nITEM: ATOMS id x y z\n1 0 0 0\n"},
        {7, "two bounds of the box were expected", with(frame, "\n0 5\n", "\n0 5 1\n")},
        {7, "the upper bound of the box must be above", with(frame, "\n0 5\n", "\n5 5\n")},
        {7, "a bound of the box must be a finite number", with(frame, "\n0 5\n", "\n0 inf\n")},
        {9, "the atoms have no positions", with(frame, "xu", "q")},
        {9, "the atoms have no column 'id'", with(frame, "id", "no")},
        {10, "3 columns, but 'ITEM: ATOMS' names 4", with(frame, "2 1 2 3", "2 1 2")},
        {10, "xu must be a finite number", with(frame, "2 1 2 3", "2 nan 2 3")},
        {11, "id 2 occurs twice", with(frame, "\n1 0.25", "\n2 0.25")},
        {11, "id -5: ids must not be negative", with(frame, "\n1 0.25", "\n-5 0.25")},
        {10, "the file ends after 1 of 2 atoms", with(frame, "1 0.25 -1 2e-3\n", "")},
        {10, "is more than 1000000 edges away", with(frame, "2 1 2 3", "2 1e9 2 3")},
        {1, "unknown item 'GRID'", with(frame, "TIMESTEP", "GRID")},
        {1, "the box must be", with(frame, "TIMESTEP", "BOX BOUNDS ff ff ff")},
        {9, "a step that is not negative, a number of atoms and a box",
         with(frame, "ITEM: TIMESTEP\n7\n", "").insert(0, "ITEM: TIME\n7\n")},
        {11, "type '2' beside '1'", head + "ITEM: ATOMS id type x y z\n1 1 0 0 3\n2 2 0 1 3\n"},
        {11, "element 'Kr' beside 'Ar'", head + "ITEM: ATOMS id type element x y z\n1 1 Ar 0 0 3\n2 1 Kr 0 1 3\n"},
        {11, "mass '2' beside '1'", head + "ITEM: ATOMS id mass x y z\n1 1 0 0 3\n2 2 0 1 3\n"},
        {2, "the file is in units 'metal'; a LAMMPS dump must be in units 'lj'", "ITEM: UNITS\nmetal\n" + frame},
    };
    for (const auto& [line, fragment, text] : cases) {
        CAPTURE(text);
        CHECK_THAT(data_error([&] { static_cast<void>(read_text(text)); }),
                   Contains("start.txt:" + std::to_string(line) + ": ") && Contains(fragment));
    }
}

TEST_CASE("atoms of a dump are of one kind in all frames, masses read") {
    const auto frame_of = [](const std::string& kind) {
        return head + "ITEM: ATOMS id element x y z vx vy vz mass\n1 " + kind + " 0 0 3 1 2 3 1.5\n2 " + kind +
               " 0 1 3 4 5 6 1.5\n";
    };
    const Frame found = read_text(frame_of("Ar"));
    CHECK(found.configuration.masses == std::vector<double>{1.5, 1.5});
    CHECK(found.configuration.velocities == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    const WrittenFile written(frame_of("Ar") + frame_of("Kr"));
    LammpsDumpTrajectory reader(written.path());
    Frame frame;
    REQUIRE(reader.next(frame));
    CHECK_THAT(data_error([&] { static_cast<void>(reader.next(frame)); }),
               Contains("start.txt:21: frame 2: element 'Kr' beside 'Ar', but ljmd has one kind of atom"));
}
