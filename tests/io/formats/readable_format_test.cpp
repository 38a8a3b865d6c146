#include "io/formats/readable_format.hpp"

#include <fstream>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// The name of the format of a file with this text; empty: it has none.
std::string name_of(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << text;
    const auto format = format_of(folder / "file");
    return format ? format->name : "";
}

const std::string dump =
    "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS "
    "id x y z\n1 1 2 3\n";

}  // namespace

TEST_CASE("formats are known by their first lines") {
    CHECK(name_of("9 9 9\n1\n1 1 1\n") == "a NIST sample configuration");
    CHECK(name_of("9 9 9\n\n1 atoms\n0 9 xlo xhi\n") == "a LAMMPS data file");
    CHECK(name_of("title\n\n1 atoms\n") == "a LAMMPS data file");
    CHECK(name_of("1\n864 atoms\nX 0 0 0\n") == "an extended XYZ file");
    CHECK(name_of(dump) == "a LAMMPS dump");
    for (const char* none : {"words\n", "1 2\n", "1 2 3 4\n", "item: TIMESTEP\n"}) {
        CHECK(name_of(none).empty());
    }
    CHECK_THROWS_WITH(name_of(""), Contains("the file is empty"));
    CHECK_THROWS_AS(format_of("nowhere"), DataError);
}

TEST_CASE("each format has a name with its article, and reads configurations") {
    for (const ReadableFormat& format : all_readable_formats()) {
        CHECK((format.name.starts_with("a ") || format.name.starts_with("an ")));
        CHECK(format.configuration);
        CHECK_THAT(readable_formats(false), Contains(format.name));
        CHECK((readable_formats(true).find(format.name) != std::string::npos) == static_cast<bool>(format.trajectory));
    }
}

TEST_CASE("of a trajectory the last frame is a configuration, if the file is whole") {
    const TemporaryFolder folder;
    const auto last = [&](const std::string& text) {
        std::ofstream(folder / "file") << text;
        return format_of(folder / "file")->configuration(folder / "file", {});
    };
    std::string two = dump + dump;
    two.replace(two.rfind("TIMESTEP\n7"), 10, "TIMESTEP\n9");
    two.replace(two.rfind("1 1 2 3"), 7, "1 4 5 6");
    CHECK(last(two).positions.front() == Vec3(4.0, 5.0, 6.0));
    CHECK(last(two).step == 9);
    CHECK_THROWS_AS(last(two.substr(0, two.size() - 4)), DataError);
}
