#include "io/formats/nist_format.hpp"

#include "catch.hpp"

#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::Malformed;
using ljmd::test::WrittenFile;

namespace {

Configuration read(const std::filesystem::path& path) {
    TextFile file(path);
    return read_nist(file);
}

Configuration read_text(const std::string& text) {
    return read(WrittenFile(text).path());
}

}  // namespace

TEST_CASE("the NIST sample configurations are read as they stand") {
    struct Sample {
        int number;
        std::size_t count;
        double edge;
        Vec3 first;
        Vec3 last;
    };
    const std::vector<Sample> samples{{1,
                                       800,
                                       10.0,
                                       {-1.126362593256E-01, 1.385093082507E+00, -8.842035145736E-01},
                                       {3.497455843197E+00, 3.754925406415E-01, 4.393398690912E+00}},
                                      {2,
                                       200,
                                       8.0,
                                       {-7.892790848222E-01, -3.263959282465E+00, -1.449690661620E-01},
                                       {-3.756097128281E+00, 1.760741543798E+00, -1.982360989088E-01}},
                                      {3,
                                       400,
                                       10.0,
                                       {-6.864555422454E-01, -4.390290248757E+00, -3.403841395696E+00},
                                       {-1.656744855373E+00, -3.002055613392E+00, 2.297216607380E+00}},
                                      {4,
                                       30,
                                       8.0,
                                       {1.077169909511E+00, -1.020988125886E+00, -1.348259447733E+00},
                                       {2.592655226763E+00, 3.786335083587E+00, -1.252452130644E+00}}};
    for (const Sample& sample : samples) {
        CAPTURE(sample.number);
        const std::string name = "/nist/lj_sample_config_periodic" + std::to_string(sample.number) + ".txt";
        const Configuration configuration = read(LJMD_TEST_DATA + name);
        CHECK(configuration.edges == Vec3::Constant(sample.edge));
        REQUIRE(configuration.positions.size() == sample.count);
        CHECK(configuration.positions.front() == sample.first);
        CHECK(configuration.positions.back() == sample.last);
        CHECK(configuration.velocities.empty());
        CHECK(configuration.masses.empty());
    }
}

TEST_CASE("NIST atoms are returned in the order of their ids, which start at 1 or 0") {
    for (const std::string text :
         {"4 5 6\n3\n 3 3 0 0\n 1 1 0 0\n 2 2 0 0\n", "4 5 6\n3\n2 3 0 0\n0 1 0 0\n1 2 0 0\n\n \n",
          "\xEF\xBB\xBF"
          "4 5 6\r\n3\r\n3 3 0 0\r\n1 1 0 0\r\n2 2 0 0"}) {
        CAPTURE(text);
        const Configuration configuration = read_text(text);
        CHECK(configuration.edges == Vec3(4.0, 5.0, 6.0));
        CHECK(configuration.positions == std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    }
}

TEST_CASE("malformed NIST files are refused with the line") {
    const std::string head = "4 5 6\n3\n";
    const std::vector<Malformed> cases{
        {1, "expected three box edges", "4 5\n3\n"},
        {1, "a box edge must be a finite number, found 'nan'", "4 nan 6\n1\n1 0 0 0\n"},
        {1, "must be positive and finite, found -5", "4 -5 6\n1\n1 0 0 0\n"},
        {1, "must be positive and finite, found 0", "4 0 6\n1\n1 0 0 0\n"},
        {1, "differ by more than a factor of", "4 1e-300 6\n1\n1 0 0 0\n"},
        {1, "the volume of the box is outside", "1e200 1e200 1e200\n1\n1 0 0 0\n"},
        {1, "the file ends before the number of atoms", "4 5 6\n"},
        {2, "expected the number of atoms, found '3 x'", "4 5 6\n3 x\n"},
        {2, "the number of atoms must be an integer, found '1.5'", "4 5 6\n1.5\n"},
        {2, "must be at least 1, found 0", "4 5 6\n0\n"},
        {2, "must be at least 1, found -1", "4 5 6\n-1\n"},
        {2, "announces 1000000000000 atoms, but only 1 line follows", "4 5 6\n1000000000000\n1 0 0 0\n"},
        {2, "outside the range of 64-bit integers", "4 5 6\n9223372036854775808\n1 0 0 0\n"},
        {4, "the file ends after 2 of 3 atoms", head + "1 1.000000000 0 0\n2 2.000000000 0 0\n"},
        {4, "blank line where atom 2 of 3 should stand", head + "1 1 0 0\n\n2 2 0 0\n3 3 0 0\n"},
        {6, "a line follows the last of 3 atoms", head + "1 1 0 0\n2 2 0 0\n3 3 0 0\n4 3.5 0 0\n"},
        {4, "expected 'id x y z', found '2 2 0'", head + "1 1 0 0\n2 2 0\n3 3 0 0\n"},
        {4, "expected 'id x y z', found '2 2 0 0 0'", head + "1 1 0 0\n2 2 0 0 0\n3 3 0 0\n"},
        {4, "a coordinate must be a finite number, found 'inf'", head + "1 1 0 0\n2 2 inf 0\n3 3 0 0\n"},
        {4, "the id must be an integer, found '2.0'", head + "1 1 0 0\n2.0 2 0 0\n3 3 0 0\n"},
        {5, "id 2 occurs twice, first in line 4", head + "1 1 0 0\n2 2 0 0\n2 3 0 0\n"},
        {3, "id -1: ids must not be negative", head + "-1 1 0 0\n1 2 0 0\n2 3 0 0\n"},
        {3, "atom 2 is more than 1000000 edges away", head + "2 1 0 1e8\n1 2 0 0\n3 3 0 0\n"}};
    for (const Malformed& wrong : cases) {
        CAPTURE(wrong.text);
        const std::string message = data_error([&] { (void)read_text(wrong.text); });
        CHECK_THAT(message, Catch::Contains("start.txt:" + std::to_string(wrong.line) + ": "));
        CHECK_THAT(message, Catch::Contains(wrong.fragment));
    }
}

TEST_CASE("atoms at the same place modulo the box are refused by their ids") {
    const auto error = [](const std::string& atoms) {
        return data_error([&] { (void)read_text("4 8 6\n3\n" + atoms); });
    };
    const std::string same = "atoms 1 and 3 are at the same place in the periodic box";
    CHECK_THAT(error("3 0.5 0 1\n2 2 0 0\n1 0.5 0 1\n"), Catch::Contains("start.txt:5: " + same));
    CHECK_THAT(error("1 0.5 0 1\n2 2 0 0\n3 4.5 -8 -11\n"), Catch::Contains("start.txt:5: " + same));
    CHECK_THAT(error("1 0 0 0\n2 2 0 0\n3 4 0 0\n"), Catch::Contains(same));
    CHECK_THAT(error("1 0 0 0\n2 2 0 0\n3 3.9999999999999996 0 0\n"), Catch::Contains(same));  // the box rounds to 4
    CHECK_THAT(error("1 -1e-300 0 0\n2 2 0 0\n3 0 0 0\n"), Catch::Contains(same));
    CHECK(error("1 0.5 0 1\n2 2 0 0\n3 0.5 0 1.0000001\n") == "no DataError");
}
