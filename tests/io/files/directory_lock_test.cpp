#include "io/files/directory_lock.hpp"

#include <optional>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a directory is one run's at a time, and free again when that ends") {
    const ScratchDirectory folder;
    std::optional<DirectoryLock> first;
    first.emplace(folder.path());
    CHECK(DirectoryLock::is_held(folder.path()));
    CHECK_THROWS_AS(DirectoryLock(folder.path()), InUseError);
    CHECK_THROWS_WITH(DirectoryLock(folder.path()), Contains("another run is writing to " + folder.path().string()));
    first.reset();
    CHECK_FALSE(DirectoryLock::is_held(folder.path()));
    CHECK_FALSE(DirectoryLock::is_held(folder.path() / "none"));
    const std::filesystem::path in_a_circle = folder.path() / "circle";
    std::filesystem::create_symlink(in_a_circle, in_a_circle);
    CHECK_THROWS_WITH(DirectoryLock::is_held(in_a_circle), Contains("circle': "));
    std::filesystem::remove(in_a_circle);
    CHECK_NOTHROW(DirectoryLock(folder.path()));
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("what is no directory cannot be locked") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(DirectoryLock(folder / "none"), FileError);
    std::ofstream(folder / "file") << "text";
    CHECK_THROWS_AS(DirectoryLock(folder / "file"), FileError);
}
