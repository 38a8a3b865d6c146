#include "io/formats/lammps_data_reader.hpp"

#include "catch.hpp"

#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::Malformed;
using ljmd::test::WrittenFile;

namespace {

Configuration read_text(const std::string& text) {
    const WrittenFile written(text);
    TextFile file(written.path());
    return read_lammps_data(file);
}

const std::string title = "LAMMPS data file, units = lj\n";
const std::string box = "0 4 xlo xhi\n-1 4 ylo yhi\n1 7 zlo zhi\n";
const std::string head = title + "2 atoms\n1 atom types\n" + box;  // six lines

}  // namespace

TEST_CASE("a full LAMMPS data file is read: counts, box, masses, images, velocities, sections that do not matter") {
    const Configuration configuration = read_text(
        "LAMMPS data file via write_data, version 23 Jun 2022, timestep = 20, units = lj\n\n"
        "3 atoms  # three of them\n1 atom types\n0 bonds\n2 extra bond per atom\n\n" +
        box +
        "\nMasses\n\n1 2.5\n\nPair Coeffs # lj/cut\n\n1 1 1\n\nPairIJ Coeffs\n\n1 1 1 1\n\n"
        "Atoms # atomic\n\n3 1 3 0 1 0 0 0\n1 1 1 0 2 -1 0 2\n2 1 2 0 1 0 1 0 # last\n\n"
        "Velocities\n\n2 0 2 0\n3 0 0 3\n1 1 0 0\n");
    CHECK(configuration.edges == Vec3(4, 5, 6));
    CHECK(configuration.positions == std::vector<Vec3>{{1 - 4, 1, 1 + 12}, {2, 1 + 5, 0}, {3, 1, 0}});
    CHECK(configuration.velocities == std::vector<Vec3>{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
    CHECK(configuration.masses == std::vector<double>(3, 2.5));
}

TEST_CASE("a LAMMPS data file needs neither masses, hint, images nor velocities") {
    const Configuration configuration = read_text(head + "Atoms\n2 1 2 0 1\n1 1 1 0 1");
    CHECK(configuration.positions == std::vector<Vec3>{{1, 1, 0}, {2, 1, 0}});
    CHECK(configuration.velocities.empty());
    CHECK(configuration.masses.empty());
}

TEST_CASE("tilt factors of zero, or of rounding, are an orthogonal box in LAMMPS data") {
    const std::string atoms = "\nAtoms\n\n1 1 1 0 1\n2 1 2 0 1\n";
    for (const std::string tilt : {"0 0 0", "0.0 -0.0 0.0", "4e-16 0 -1e-15", "0.0D+00 0 0"}) {
        CAPTURE(tilt);
        CHECK(read_text(head + tilt + " xy xz yz\n" + atoms).edges == Vec3(4, 5, 6));
        CHECK(read_text(title + tilt + " xy xz yz\n2 atoms\n" + box + atoms).edges == Vec3(4, 5, 6));
    }
}

TEST_CASE("ids may have gaps, as when atoms were deleted") {
    const Configuration configuration =
        read_text(head + "Atoms\n\n900 1 2 0 1\n7 1 1 0 1\n\nVelocities\n\n7 1 0 0\n900 2 0 0\n");
    CHECK(configuration.positions == std::vector<Vec3>{{1, 1, 0}, {2, 1, 0}});
    CHECK(configuration.velocities == std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}});
}

TEST_CASE("sections may stand in the order in which LAMMPS accepts them, with CRLF") {
    const Configuration configuration = read_text(
        "\r\n2 atoms\r\n0 4 xlo xhi\r\n0 4 ylo yhi\r\n0 4 zlo zhi\r\n\r\nAtoms\r\n\r\n1 1 1 0 0\r\n2 1 2 0 0\r\n\r\n"
        "Masses\r\n\r\n1 1.0\r\n");
    CHECK(configuration.positions.size() == 2);
    CHECK(configuration.masses == std::vector<double>(2, 1.0));
}

TEST_CASE("malformed LAMMPS data files are refused with the line") {
    const std::string atoms = "Atoms # atomic\n\n1 1 1 0 1\n2 1 2 0 1\n";  // lines 7 to 10
    const std::vector<Malformed> cases{
        {1, "the file is in units 'metal'; LAMMPS data must be in units 'lj'",
         "LAMMPS, units = metal\n2 atoms\n" + box + atoms},
        {3, "the number of atom types must be from 1 to", title + "2 atoms\n0 atom types\n" + box + atoms},
        {2, "must be at least 1, found 0", title + "0 atoms\n" + box},
        {2, "must be an integer, found '2.0'", title + "2.0 atoms\n" + box + atoms},
        {2, "announces 1000000000000 atoms, but only 6 lines follow", title + "1000000000000 atoms\n" + box + atoms},
        {3, "the number of atoms is given twice", title + "2 atoms\n2 atoms\n" + box + atoms},
        {2, "the header does not give the number of atoms", title + "Atoms\n"},
        {5, "the header must give the box", title + "2 atoms\n0 4 xlo xhi\n0 4 ylo yhi\n" + atoms},
        {3, "the header must give the box", title + "1 atoms\n0 4 xlo xhi"},
        {3, "xhi must be above xlo", title + "2 atoms\n4 0 xlo xhi\n" + atoms},
        {3, "xhi must be above xlo", title + "2 atoms\n4 4 xlo xhi\n" + atoms},
        {3, "xlo must be a finite number", title + "2 atoms\n-inf 4 xlo xhi\n" + atoms},
        {5, "edges of the box must be positive and finite, found inf",
         title + "2 atoms\n-1e308 1e308 xlo xhi\n-1 4 ylo yhi\n1 7 zlo zhi\n" + atoms},
        {7, "the box is tilted", head + "0 1e-9 0 xy xz yz\n" + atoms},
        {7, "a tilt factor must be a finite number", head + "0 nan 0 xy xz yz\n" + atoms},
        {7, "expected 'xy xz yz xy xz yz'", head + "0 0 xy xz yz\n" + atoms},
        {7, "the box is tilted", head + "4 0 1 avec\n" + atoms},
        {7, "expected three numbers and 'avec'", head + "4 0 avec\n" + atoms},
        {7, "the file has bonds, but the atoms of ljmd have the pair potential alone", head + "1 bonds\n" + atoms},
        {11, "the file has angles, but", head + atoms + "Angles\n\n1 1 1 2 3\n"},
        {8, "epsilon = '2.0' and sigma = '1.0', but in reduced units both are 1",
         head + "Pair Coeffs\n1 2.0 1.0\n" + atoms},
        {8, "epsilon = '1' and sigma = '1.1', but", head + "PairIJ Coeffs # lj/cut\n1 1 1 1.1\n" + atoms},
        {8, "coefficients of pair style 'morse', which are not read", head + "Pair Coeffs # morse\n1 1 1 1\n" + atoms},
        {8, "coefficients of pair style 'lj/class2'", head + "Pair Coeffs # hybrid\n1 lj/class2 1 1\n" + atoms},
        {7, "atom style 'full' cannot be read; the allowed style is 'atomic'",
         head + "Atoms # full\n\n1 1 1 0 0 0 0\n"},
        {9, "6 columns, but atom style 'atomic' has 5", head + "Atoms\n\n1 1 0.5 1 0 1\n2 1 0.5 2 0 1\n"},
        {10, "8 columns, but atom style", head + "Atoms\n\n1 1 1 0 1\n2 1 2 0 1 0 0 0\n"},
        {10, "7 columns, but atom style", head + "Atoms\n\n1 1 1 0 1 0 0 0\n2 1 2 0 1 0 0\n"},
        {10, "0 columns, but atom style", head + "Atoms\n\n1 1 1 0 1\n# nothing\n2 1 2 0 1\n"},
        {10, "atom type 2, but the header has atom types 1 to 1", head + "Atoms\n\n1 1 1 0 1\n2 2 2 0 1\n"},
        {10, "a coordinate must be a finite number, found 'nan'", head + "Atoms\n\n1 1 1 0 1\n2 1 2 nan 1\n"},
        {9, "an image flag must be an integer, found '0.5'", head + "Atoms\n\n1 1 1 0 1 0 0 0.5\n2 1 2 0 1 0 0 0\n"},
        {9, "atom 1 is more than 1000000 edges away", head + "Atoms\n\n1 1 1 0 1 0 0 2000000000000\n2 1 2 0 1 0 0 0\n"},
        {10, "id 1 occurs twice, first in line 9", head + "Atoms\n\n1 1 1 0 1\n1 1 2 0 1\n"},
        {9, "id -3: ids must not be negative", head + "Atoms\n\n-3 1 1 0 1\n1 1 2 0 1\n"},
        {10, "atoms 1 and 2 are at the same place", head + "Atoms\n\n1 1 1 0 1\n2 1 5 0 1\n"},
        {9, "the file ends after 1 of 2 atoms", head + "Atoms\n\n1 1 1 0 1.000000000000000\n"},
        {8, "the file ends before the lines of section Atoms", head + "Atoms\n\n"},
        {11, "a line follows the last one of section Atoms", head + atoms + "3 1 3 0 1\n"},
        {12, "section Atoms is given twice", head + atoms + "\n" + atoms},
        {8, "the file has no section Atoms", head + "Pair Coeffs\n1 1 1\n"},
        {6, "the file has no section Atoms", head},
        {7, "unknown section 'Atom'", head + "Atom\n"},
        {11, "unknown section 'Velo'", head + atoms + "Velo"},
        {7, "section Velocities must follow section Atoms", head + "Velocities\n\n1 0 0 0\n2 0 0 0\n" + atoms},
        {13, "expected 'id vx vy vz', found '2 0 0'", head + atoms + "Velocities\n1 0 0 0\n2 0 0\n"},
        {13, "id 1 occurs twice, first in line 12", head + atoms + "Velocities\n1 0 0 0\n1 0 0 0\n"},
        {12, "the ids of section Velocities are not those of section Atoms",
         head + atoms + "Velocities\n0 0 0 0\n1 0 0 0\n"},
        {14, "a line follows the last one of section Velocities",
         head + atoms + "Velocities\n1 0 0 0\n2 0 0 0\n3 0 0 0\n"},
        {14, "section Velocities is given twice", head + atoms + "Velocities\n1 0 0 0\n2 0 0 0\nVelocities\n"},
        {8, "atom type 2, but the header has atom types 1 to 1", head + "Masses\n2 1.0\n" + atoms},
        {8, "the mass must be positive, found 0", head + "Masses\n1 0\n" + atoms},
        {9, "section Masses is given twice", head + "Masses\n1 1\nMasses\n1 1\n" + atoms}};
    for (const Malformed& wrong : cases) {
        CAPTURE(wrong.text);
        const std::string message = data_error([&] { (void)read_text(wrong.text); });
        CHECK_THAT(message, Catch::Contains("start.txt:" + std::to_string(wrong.line) + ": "));
        CHECK_THAT(message, Catch::Contains(wrong.fragment));
    }
}

TEST_CASE("of several atom types in LAMMPS data one may have all atoms, and its mass and coefficients count") {
    const std::string two = title + "2 atoms\n2 atom types\n" + box + "Masses\n\n1 3\n2 1\n\n" +
                            "Pair Coeffs # lj/cut\n\n1 5 5\n2 1 1 2.5\n\nAtoms\n\n";
    const Configuration second = read_text(two + "1 2 1 0 1\n2 2 2 0 1\n");
    CHECK(second.masses == std::vector<double>(2, 1.0));
    REQUIRE(second.remarks.size() == 1);
    CHECK_THAT(second.remarks[0], Catch::Contains("a cutoff (2.5), which is not taken"));
    CHECK_THAT(data_error([&] { (void)read_text(two + "1 1 1 0 1\n2 1 2 0 1\n"); }), Catch::Contains("epsilon = '5'"));
    CHECK_THAT(data_error([&] { (void)read_text(two + "1 2 1 0 1\n2 1 2 0 1\n"); }),
               Catch::Contains("atom type 1 beside 2, but ljmd has one kind of atom"));
}

TEST_CASE("three vectors along the axes are an orthogonal box in LAMMPS data") {
    const Configuration found = read_text(title + "2 atoms\n4 0 0 avec\n0 5 0 bvec\n0 0 6 cvec\n0 -1 1 abc origin\n" +
                                          "Atoms\n\n1 1 1 0 1\n2 1 2 0 1\n");
    CHECK(found.edges == Vec3(4, 5, 6));
    CHECK(found.positions == std::vector<Vec3>{{1, 1, 0}, {2, 1, 0}});
}

TEST_CASE("the count of atoms marks a LAMMPS header") {
    CHECK(is_lammps_atom_count(" 864  atoms # all"));
    CHECK_FALSE(is_lammps_atom_count("864 atoms of argon"));
    CHECK_FALSE(is_lammps_atom_count("many atoms"));
    CHECK_FALSE(is_lammps_atom_count(""));
}
