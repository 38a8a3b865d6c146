#include "io/files/open_directory.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string too_long(300, 'x');

}  // namespace

TEST_CASE("an open directory knows whether it is where it was") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "out");
    const OpenDirectory out(folder / "out");
    CHECK(out.path() == folder / "out");
    CHECK(out.is_at_its_path());
    CHECK_NOTHROW(out.require_at_its_path());
    CHECK_NOTHROW(out.sync());
    std::filesystem::rename(folder / "out", folder / "moved");
    CHECK_FALSE(out.is_at_its_path());
    CHECK_THROWS_AS(out.require_at_its_path(), InUseError);
    std::filesystem::create_directory(folder / "out");
    CHECK_FALSE(out.is_at_its_path());
    std::filesystem::remove(folder / "out");
    std::filesystem::create_symlink(folder / "moved", folder / "out");
    CHECK(out.is_at_its_path());  // it is the same one
}

TEST_CASE("the empty path is the working directory") {
    CHECK(OpenDirectory("").is_at_its_path());
    const OutputPlace place{std::filesystem::path("a.txt")};
    CHECK(place.path() == "a.txt");
    CHECK(place.name == "a.txt");
}

TEST_CASE("what is no directory cannot be opened, and the message names what was wanted") {
    const TemporaryFolder folder;
    const std::string none = (folder / "none").string();
    CHECK_THROWS_WITH(OpenDirectory(none), "cannot open the directory '" + none + "': No such file or directory");
    CHECK_THROWS_WITH(OutputPlace(folder / "none/a"), "cannot create '" + none + "/a': No such file or directory");
    CHECK_THROWS_AS(OpenDirectory("/dev/null"), FileError);
}

TEST_CASE("a directory within another is made, found again, and never reached through a link") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "out");
    const OpenDirectory out(folder / "out");
    CHECK(out.made_within("points").path() == folder / "out/points");
    CHECK(out.made_within("points").is_at_its_path());
    std::filesystem::create_directory(folder / "elsewhere");
    std::filesystem::create_symlink(folder / "elsewhere", folder / "out/link");
    CHECK_THROWS_AS(out.made_within("link"), FileError);
    CHECK_THROWS_AS(out.made_within("no/such"), FileError);
}

TEST_CASE("a place knows whether an open file lies there") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "text";
    const int descriptor = ::open((folder / "a").c_str(), O_RDONLY | O_CLOEXEC);
    const OutputPlace place(folder / "a");
    CHECK(place.holds(descriptor));
    CHECK_FALSE(OutputPlace(folder / "none").holds(descriptor));
    CHECK_THROWS_WITH(OutputPlace(folder / too_long).holds(descriptor), Contains("File name too long"));
    std::filesystem::rename(folder / "a", folder / "b");
    std::filesystem::create_symlink(folder / "b", folder / "a");
    CHECK_FALSE(place.holds(descriptor));
    ::close(descriptor);
    CHECK_THROWS_WITH(place.holds(descriptor), Contains("cannot look at '" + (folder / "a").string() + "': Bad file"));
}
