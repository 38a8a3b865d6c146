#include "io/files/claimed_file.hpp"

#include <optional>

#include "io/files/directory_lock.hpp"
#include "io/files/process.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

TEST_CASE("a file is claimed by one at a time, and keeps what was in it") {
    const TemporaryFolder folder;
    const fs::path path = folder / "log";
    std::ofstream(path) << "before\n";
    CHECK_FALSE(ClaimedFile::is_held(path));
    auto first = ClaimedFile::claim(path);
    REQUIRE(first.has_value());
    CHECK(ClaimedFile::is_held(path));
    CHECK_FALSE(ClaimedFile::claim(path).has_value());
    first->append("after\n");
    CHECK(content_of(path) == "before\nafter\n");
    first->clear();
    first->append("new\n");
    CHECK(content_of(path) == "new\n");
    first.reset();
    CHECK_FALSE(ClaimedFile::is_held(path));
    CHECK(ClaimedFile::claim(path).has_value());
}

TEST_CASE("a child that writes to a claimed file holds it for as long as it runs") {
    const TemporaryFolder folder;
    const fs::path path = folder / "log";
    auto file = ClaimedFile::claim(path);
    REQUIRE(file.has_value());
    ChildProcess child({.program = "/bin/sh",
                        .arguments = {"-c", "while ! test -e done; do sleep 0.01; done; echo end"},
                        .directory = folder / "",
                        .output = {},
                        .output_descriptor = file->descriptor()});
    file.reset();
    CHECK(ClaimedFile::is_held(path));
    CHECK_FALSE(ClaimedFile::claim(path).has_value());
    std::ofstream(folder / "done") << "";
    CHECK(child.wait() == 0);
    CHECK_FALSE(ClaimedFile::is_held(path));
    CHECK(content_of(path) == "end\n");
}

TEST_CASE("what cannot be claimed is an error, and what is not there is not held") {
    const TemporaryFolder folder;
    CHECK_FALSE(ClaimedFile::is_held(folder / "none"));
    CHECK_THROWS_AS(ClaimedFile::claim(folder / "none/log"), FileError);
    CHECK_THROWS_AS(ClaimedFile::claim(folder / ""), FileError);
    fs::create_symlink(folder / "precious", folder / "link");
    CHECK_THROWS_AS(ClaimedFile::claim(folder / "link"), FileError);
    CHECK_FALSE(ClaimedFile::is_held(folder / "link"));
    CHECK_FALSE(fs::exists(folder / "precious"));
}

TEST_CASE("several share a directory, and nobody has it alone meanwhile") {
    const TemporaryFolder folder;
    std::optional<SharedDirectory> one(folder / "");
    std::optional<SharedDirectory> other(folder / "");
    CHECK_THROWS_AS(DirectoryLock(folder / ""), InUseError);
    CHECK_FALSE(DirectoryLock::is_held(folder / ""));
    one.reset();
    other.reset();
    const DirectoryLock alone(folder / "");
    CHECK_THROWS_AS(SharedDirectory(folder / ""), InUseError);
}
