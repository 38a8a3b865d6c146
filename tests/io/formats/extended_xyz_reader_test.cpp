#include "io/formats/extended_xyz_reader.hpp"

#include "catch.hpp"

#include <random>

#include "io/formats/extended_xyz_writer.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using ljmd::test::data_error;
using ljmd::test::Malformed;
using ljmd::test::WrittenFile;

namespace {

Configuration read_text(const std::string& text, const std::optional<SubstanceUnits>& units = std::nullopt) {
    const WrittenFile written(text);
    TextFile file(written.path());
    return read_extended_xyz(file, units);
}

const std::string lattice = "Lattice=\"4 0 0 0 5 0 0 0 6\" ";
const std::string frame = "2\n" + lattice + "\nX 1 0 0\nX 2 0 0\n";

}  // namespace

TEST_CASE("an extended XYZ file with everything in it") {
    const Configuration configuration =
        read_text("3\n" + lattice +
                  "Properties=species:S:1:pos:R:3:charge:R:1:velo:R:3:id:I:1:mass:R:1 pbc=\"T T T\" Time=1.5 step=30 "
                  "units=reduced\nX 3 0 -9 0.1 0 0 3 3 1\nX 1 0 0 0.1 1 0 0 1 1\nX 2 77 0 0.1 0 2 0 2 1.0\n");
    CHECK(configuration.edges == Vec3(4, 5, 6));
    CHECK(configuration.positions == std::vector<Vec3>{{1, 0, 0}, {2, 77, 0}, {3, 0, -9}});
    CHECK(configuration.velocities == std::vector<Vec3>{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
    CHECK(configuration.masses == std::vector<double>{1, 1, 1});
    CHECK(configuration.time == 1.5);
    CHECK(configuration.step == 30);
}

TEST_CASE("without ids the order in the file counts, and absent columns stay empty") {
    const Configuration configuration = read_text(
        "\xEF\xBB\xBF"
        "2\r\n" +
        lattice + "\r\nX 2 0 0\r\nX 1 0 0");
    CHECK(configuration.positions == std::vector<Vec3>{{2, 0, 0}, {1, 0, 0}});
    CHECK(configuration.velocities.empty());
    CHECK(configuration.masses.empty());
    CHECK_FALSE(configuration.time);
    CHECK_FALSE(configuration.step);
}

TEST_CASE("the last of several frames is read, whatever the number of atoms in the others") {
    const Configuration configuration =
        read_text(frame + frame + "\n1\nLattice=\"7 0 0 0 7 0 0 0 7\" step=9\nX 5 6 7\n\n");
    CHECK(configuration.edges == Vec3(7, 7, 7));
    CHECK(configuration.positions == std::vector<Vec3>{{5, 6, 7}});
    CHECK(configuration.step == 9);
}

TEST_CASE("an extended XYZ file in SI units is converted through the substance") {
    const double dalton = 1.66053906660e-27;
    const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * dalton);
    const std::string text =
        "2\nLattice=\"34.05 0 0 0 34.05 0 0 0 68.1\" Properties=species:S:1:pos:R:3:velo:R:3:mass:R:1 Time=2.0 step=3 "
        "units=si\nAr 3.405 0 0 0 1.5 0 39.948\nAr 0 -6.81 0 0 0 0 39.948\n";
    const Configuration configuration = read_text(text, argon);
    const double tau = 3.405e-10 * std::sqrt(39.948 * dalton / (119.8 * 1.380649e-23));  // [s]
    CHECK(configuration.edges[0] == Approx(10.0).epsilon(1e-14));
    CHECK(configuration.edges[2] == Approx(20.0).epsilon(1e-14));
    CHECK(configuration.positions[0][0] == Approx(1.0).epsilon(1e-14));
    CHECK(configuration.positions[1][1] == Approx(-2.0).epsilon(1e-14));
    CHECK(configuration.velocities[0][1] ==
          Approx(150.0 * tau / 3.405e-10).epsilon(1e-13));  // 1.5 angstrom/ps = 150 m/s
    CHECK(configuration.masses[0] == Approx(1.0).epsilon(1e-9));
    CHECK(configuration.masses[1] == configuration.masses[0]);
    CHECK(configuration.time == Approx(2e-12 / tau).epsilon(1e-13));
    CHECK(configuration.step == 3);
    CHECK_THAT(data_error([&] { (void)read_text(text); }),
               Catch::Contains("start.txt:2: frame 1: ") && Catch::Contains("a deck with [argon] is needed"));
}

TEST_CASE("momenta of ASE are velocities times the mass of the file, or the one that ASE takes for the species") {
    const auto velocity = [](const std::string& columns, const std::string& atom, const auto& units) {
        return read_text("1\n" + lattice + columns + "\n" + atom + "\n", units).velocities.at(0);
    };
    const std::optional<SubstanceUnits> none;
    CHECK(velocity("Properties=species:S:1:pos:R:3:momenta:R:3", "X 1 2 3 0.5 -1 2", none) == Vec3(0.5, -1, 2));
    CHECK(velocity("Properties=species:S:1:pos:R:3:momenta:R:3", "ar 1 2 3 39.948 0 0", none) == Vec3(1, 0, 0));
    CHECK(velocity("Properties=pos:R:3:masses:R:1:momenta:R:3", "1 2 3 4 8 0 0", none) == Vec3(2, 0, 0));
    CHECK(velocity("Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3", "Ar 1 2 3 7 8 9 1 1 1", none) ==
          Vec3(7, 8, 9));

    const double dalton = 1.66053906660e-27;
    const double electron_volt = 1.602176634e-19;
    const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * dalton);
    const Vec3 found =
        velocity("Properties=species:S:1:pos:R:3:momenta:R:3 units=si", "Ar 1 2 3 39.948 0 0", std::optional(argon));
    const double sigma_per_tau = std::sqrt(119.8 * 1.380649e-23 / (39.948 * dalton));  // [m/s]
    CHECK(found[0] == Approx(std::sqrt(electron_volt / dalton) / sigma_per_tau).epsilon(1e-13));
}

TEST_CASE("what the comment lines lack is told beside the file") {
    const std::string cp2k = "2\n i = 1, time = 0.500, E = -12.5\nAr 1 0 0\nAr 2 0 0\n";
    const WrittenFile written(cp2k + cp2k);
    TextFile file(written.path());
    CHECK(read_extended_xyz(file, std::nullopt, lattice).edges == Vec3(4, 5, 6));
    ExtendedXyzTrajectory reader(written.path(), std::nullopt, lattice);
    Frame found;
    REQUIRE(reader.next(found));
    CHECK_FALSE((found.configuration.step || found.configuration.time));
    REQUIRE(reader.next(found));
    CHECK(found.configuration.edges == Vec3(4, 5, 6));
    CHECK_FALSE(reader.next(found));
}

TEST_CASE("names of properties match in any case, unused columns may hold anything, and vectors left out are told") {
    const Configuration found =
        read_text("1\n" + lattice + "Properties=Species:S:1:Pos:R:3:Velocity:R:3:Forces:R:3:dipole:R:3:charge:R:1\n" +
                  "X 1 0 0 4 5 6 nan inf none 0 0 1 -1\n");
    CHECK(found.positions == std::vector<Vec3>{{1, 0, 0}});
    CHECK(found.velocities == std::vector<Vec3>{{4, 5, 6}});
    REQUIRE(found.remarks.size() == 2);
    CHECK_THAT(found.remarks[0], Contains("the property 'dipole' of three numbers is not taken"));
    CHECK_THAT(found.remarks[1], Contains("the atoms have charges ('charge')"));
    CHECK_THAT(
        data_error([] { (void)read_text("2\n" + lattice + "Properties=SPECIES:S:1:pos:R:3\nAr 1 0 0\nKr 2 0 0\n"); }),
        Contains("species 'Kr' beside 'Ar'"));
}

TEST_CASE("ids of atoms may have gaps") {
    const Configuration found =
        read_text("2\n" + lattice + "Properties=species:S:1:pos:R:3:id:I:1\nX 1 0 0 90\nX 2 0 0 7\n");
    CHECK(found.positions == std::vector<Vec3>{{2, 0, 0}, {1, 0, 0}});
}

TEST_CASE("a configuration that ljmd wrote is read back to the last bit") {
    State state(50, Box(Vec3(7.1, 8.2, 9.3)));
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> inside(0.0, 7.0);
    std::uniform_int_distribution<int> image(-3, 3);
    for (Index i = 0; i < state.count(); ++i) {
        state.write_positions().col(i) = state.snapped({inside(random), inside(random), inside(random)});
        state.write_velocities().col(i) = Vec3(inside(random), -inside(random), 1e-9 * inside(random));
        state.set_image(i, {image(random), image(random), image(random)});
    }
    state.time = 0.1 + 0.2;
    state.step = 4321;
    const WrittenFile written("");
    write_configuration(written.path(), state, true);
    TextFile file(written.path());
    const Configuration configuration = read_extended_xyz(file, std::nullopt);
    CHECK(configuration.edges == state.box().edges());
    CHECK(configuration.time == state.time);
    CHECK(configuration.step == state.step);
    REQUIRE(configuration.positions.size() == 50);
    REQUIRE(configuration.velocities.size() == 50);
    for (Index i = 0; i < state.count(); ++i) {
        CHECK(configuration.positions[static_cast<std::size_t>(i)] == state.unwrapped(i));
        CHECK(configuration.velocities[static_cast<std::size_t>(i)] == Vec3(state.velocities().col(i)));
    }
}

TEST_CASE("malformed extended XYZ files are refused with line and frame") {
    const std::string ids = "2\n" + lattice + "Properties=species:S:1:pos:R:3:id:I:1\n";
    const std::vector<Malformed> cases{
        {1, "frame 1: the number of atoms must be an integer, found '2.5'", "2.5\n"},
        {1, "frame 1: the number of atoms must be at least 1, found 0", "0\n" + lattice + "\n"},
        {1, "frame 1: the file announces 1000000000000 atoms, but only 2 lines follow",
         "1000000000000\n" + lattice + "\nX 1 0 0\n"},
        {1, "frame 1: the file announces 1 atoms, but only 0 lines follow", "1"},
        {2, "frame 1: no Lattice", "1\nargon\nX 1 0 0\n"},
        {3, "frame 1: the file ends after 1 of 2 atoms", "2\n" + lattice + "\nX 1 0 0\n"},
        {8, "frame 2: the file ends after 2 of 3 atoms", frame + "3\n" + lattice + "\nX 1 0 0\nX 2 0 0\n"},
        {8, "frame 2: 3 columns, but Properties has 4", frame + "2\n" + lattice + "\nX 1 0 0\nX 2 0\n"},
        {4, "frame 1: blank line where atom 2 of 2 should stand", "2\n" + lattice + "\nX 1 0 0\n\nX 2 0 0\n"},
        {5, "frame 2: expected the number of atoms, found 'X 3 0 0'", frame + "X 3 0 0\n"},
        {5, "frame 2: the number of atoms must be an integer, found 'end'", frame + "end\n"},
        {3, "frame 1: 5 columns, but Properties has 4", "1\n" + lattice + "\nX 1 0 0 0\n"},
        {3, "frame 1: a coordinate must be a finite number, found 'nan'", "1\n" + lattice + "\nX 1 nan 0\n"},
        {4, "frame 1: species 'Y' beside 'X', but ljmd has one kind of atom", "2\n" + lattice + "\nX 1 0 0\nY 2 0 0\n"},
        {4, "frame 1: id 1 occurs twice, first in line 3", ids + "X 1 0 0 1\nX 2 0 0 1\n"},
        {3, "frame 1: id -7: ids must not be negative", ids + "X 1 0 0 -7\nX 2 0 0 2\n"},
        {3, "frame 1: momenta take a mass", "1\n" + lattice + "Properties=pos:R:3:momenta:R:3\n1 0 0 1 1 1\n"},
        {8, "frame 2: atoms 1 and 2 are at the same place", frame + "2\n" + lattice + "\nX 1 0 0\nX 5 0 0\n"},
        {3, "frame 1: atom 1 has the mass -1; masses must be positive",
         "1\n" + lattice + "Properties=pos:R:3:mass:R:1\n1 0 0 -1\n"}};
    for (const Malformed& wrong : cases) {
        CAPTURE(wrong.text);
        const std::string message = data_error([&] { (void)read_text(wrong.text); });
        CHECK_THAT(message, Catch::Contains("start.txt:" + std::to_string(wrong.line) + ": "));
        CHECK_THAT(message, Catch::Contains(wrong.fragment));
    }
}

TEST_CASE("frames of an extended XYZ file come one after the other, unwrapped where ljmd wrote them") {
    const WrittenFile written("2\n" + lattice + "step=3 Time=0\nX 1 0 0\nX 2 0 0\n\n2\n" + lattice +
                              "Time=0.5 step=9 positions=unwrapped\nX 5 0 0\nX -1 0 0\n\n");
    ExtendedXyzTrajectory reader(written.path(), std::nullopt);
    Frame found;
    REQUIRE(reader.next(found));
    CHECK(found.configuration.positions == std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}});
    CHECK(found.configuration.step == 3);
    CHECK_FALSE(found.configuration.is_unwrapped);
    REQUIRE(reader.next(found));
    CHECK(found.configuration.positions == std::vector<Vec3>{{5, 0, 0}, {-1, 0, 0}});
    CHECK((found.configuration.step && found.configuration.time));
    CHECK(found.configuration.step == 9);
    CHECK(found.configuration.time == 0.5);
    CHECK(found.configuration.is_unwrapped);
    CHECK_FALSE(reader.next(found));
    CHECK(reader.frames() == 2);
}

TEST_CASE("two atoms at one place are no start, but a frame like any other") {
    const std::string text = "2\n" + lattice + "\nX 1 0 0\nX 1 0 0\n";
    CHECK(data_error([&] { static_cast<void>(read_text(text)); }) != "no DataError");
    const WrittenFile written(text);
    ExtendedXyzTrajectory reader(written.path(), std::nullopt);
    Frame found;
    CHECK(reader.next(found));
}

TEST_CASE("the units of the first frame are those of all frames") {
    const SubstanceUnits argon(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
    const auto frame_in = [](const std::string& units) {
        return "2\nLattice=\"34.05 0 0 0 34.05 0 0 0 34.05\" " + units + "\nAr 0 0 0\nAr 3.405 0 0\n";
    };
    const auto edges = [&](const std::string& text) {
        const WrittenFile written(text);
        ExtendedXyzTrajectory reader(written.path(), argon);
        Frame found;
        std::vector<double> all;
        while (reader.next(found)) all.push_back(found.configuration.edges[0]);
        return all;
    };
    for (const char* later : {"units=si", ""}) {
        const std::vector<double> found = edges(frame_in("units=si") + frame_in(later));
        CHECK(found.at(0) == Approx(10.0));
        CHECK(found.at(1) == found.at(0));
    }
    CHECK(edges(frame_in("") + frame_in("units=reduced")) == std::vector<double>{34.05, 34.05});
    for (const auto& [first, second] : {std::pair{"", "si"}, {"units=reduced", "si"}, {"units=si", "reduced"}}) {
        CHECK_THAT(
            data_error([&] { edges(frame_in(first) + frame_in(std::string("units=") + second)); }),
            Catch::Contains("start.txt:6: frame 2: units=" + std::string(second) + ", but the units of frame 1"));
    }
    CHECK(read_text(frame_in("units=si") + frame_in(""), argon).edges[0] == Approx(10.0));
}

TEST_CASE("frames have ids all or none") {
    const std::string with_ids = "2\n" + lattice + "Properties=species:S:1:pos:R:3:id:I:1\nX 1 0 0 2\nX 2 0 0 1\n";
    for (const auto& [text, fragment] : {std::pair{frame + with_ids, "frame 2: ids, which frame 1 has not"},
                                         std::pair{with_ids + frame, "frame 2: no ids, which frame 1 has"}}) {
        const WrittenFile written(text);
        ExtendedXyzTrajectory reader(written.path(), std::nullopt);
        Frame found;
        REQUIRE(reader.next(found));
        CHECK_THAT(data_error([&] { static_cast<void>(reader.next(found)); }), Catch::Contains(fragment));
    }
}

TEST_CASE("all atoms of an extended XYZ file are of one kind, in whatever column and frame it is told") {
    const auto two = [](const std::string& property, const std::string& a, const std::string& b) {
        return "2\n" + lattice + "Properties=pos:R:3:" + property + "\n1 0 0 " + a + "\n2 0 0 " + b + "\n";
    };
    for (const auto& [text, fragment] :
         {std::pair{two("Z:I:1", "18", "36"), "start.txt:4: frame 1: Z '36' beside '18'"},
          std::pair{two("element:S:1", "Ar", "Kr"), "element 'Kr' beside 'Ar'"},
          std::pair{two("masses:R:1", "1", "2"), "masses '2' beside '1', but ljmd has one kind of atom"},
          std::pair{two("species:S:1", "Ar", "Ar") + two("species:S:1", "Kr", "Kr"),
                    "start.txt:7: frame 2: species 'Kr' beside 'Ar'"}}) {
        const WrittenFile written(text);
        CHECK_THAT(data_error([&] {
                       ExtendedXyzTrajectory reader(written.path(), std::nullopt);
                       for (Frame found; reader.next(found);) {
                       }
                   }),
                   Catch::Contains(fragment));
        CHECK_THAT(data_error([&] { static_cast<void>(read_text(text)); }), Catch::Contains(fragment));
    }
    CHECK(read_text(two("masses:R:1", "1", "1.0000000") + two("Z:I:1", "18", "18")).masses.empty());
}
