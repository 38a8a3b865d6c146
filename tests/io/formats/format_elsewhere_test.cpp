#include "io/formats/format_elsewhere.hpp"

#include "catch.hpp"

using namespace ljmd;
using namespace std::string_literals;
using Catch::Contains;

TEST_CASE("formats of other programs are named, with what makes a file of them that is read") {
    const auto words = [](const std::string& bytes) { return format_elsewhere("runs/a.x", bytes); };
    CHECK_THAT(words("T\0\0\0CORD\0\0"s), Contains("a trajectory in DCD") &&
                                              Contains("MDAnalysis.Universe(\"runs/a.x\"") &&
                                              Contains("write(\"a.h5md\""));
    CHECK_THAT(words("\0\0\x07\xcb\0\0"s), Contains("XTC"));
    CHECK_THAT(words("\0\0\x07\xc9\0\0"s), Contains("TRR"));
    CHECK_THAT(words("CDF\x01\0\0"s), Contains("NetCDF"));
    CHECK_THAT(words("CRYST1   10.000   10.000   10.000\n"),
               Contains("the format PDB") && Contains("ase.io.read(\"runs/a.x\""));
    CHECK_THAT(words("A title\n   27\n    1SOL    OW1    1   0.126   1.624   1.679\n"), Contains("the format GRO"));
    CHECK_THAT(format_elsewhere("it's \"a\".dcd", "....CORD"), Contains("\"it's \\\"a\\\".dcd\""));
}

TEST_CASE("what is read here, and what nobody knows, is no such format") {
    for (const std::string& bytes :
         {""s, "3\nLattice=\"6 0 0 0 6 0 0 0 6\" Properties=species:S:1:pos:R:3\nX 1 2 3\n"s, "ITEM: TIMESTEP\n0\n"s,
          "\x89HDF\r\n\x1a\n"s, "10.0 10.0 10.0\n 200\n 1 -4.2 3.9 -1.0 and more numbers to come\n"s, "hello\n"s,
          "LAMMPS data\n\n4 atoms\n1 atom types\n and so on, with lines that are long enough\n"s}) {
        CAPTURE(bytes);
        CHECK(format_elsewhere("a", bytes).empty());
    }
}
