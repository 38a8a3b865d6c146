#include "io/files/replacement_file.hpp"

#include <vector>

#include "io/files/directory_lock.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("an atomic write replaces the file and leaves nothing else") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    write_file_atomically(path, "old\n");
    write_file_atomically(path, "new\n");
    CHECK(content_of(path) == "new\n");
    CHECK(folder.count_files() == 1);
}

TEST_CASE("an atomic write that fails leaves the old file and no other") {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    write_file_atomically(path, "old\n");

    SECTION("full disk") {
        const FileSizeLimit limit(1000);
        CHECK_THROWS_WITH(write_file_atomically(path, std::string(5000, 'x')), Contains("File too large"));
    }
    SECTION("the content cannot be made") {
        CHECK_THROWS_AS(write_file_atomically(path,
                                              [](OutputFile& file) {
                                                  file.write("half");
                                                  throw PhysicsError("no");
                                              }),
                        PhysicsError);
    }
    CHECK(content_of(path) == "old\n");
    CHECK(folder.count_files() == 1);
}

TEST_CASE("an atomic write onto a folder fails and leaves nothing behind") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a");
    CHECK_THROWS_AS(write_file_atomically(folder / "a", "text"), FileError);
    CHECK(folder.count_files() == 1);
    CHECK_THROWS_AS(write_file_atomically(folder / "no/a.txt", "text"), FileError);
}

TEST_CASE("an atomic write does not follow a link that lies in its way") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "precious.txt", "precious\n");
    std::filesystem::create_symlink(folder / "precious.txt", folder / "a.txt");
    write_file_atomically(folder / "a.txt", "new\n");
    CHECK(content_of(folder / "precious.txt") == "precious\n");
    CHECK(content_of(folder / "a.txt") == "new\n");
    CHECK(folder.count_files() == 2);
}

TEST_CASE("no file is replaced but the one that is written, whatever its name") {
    const TemporaryFolder folder;
    for (const char* name : {"a.txt.tmp", "a.tmp.txt", "a.txt~", ".a.txt", ".ljmd-", ".ljmd-0123456789abcdef"}) {
        std::ofstream(folder / name) << "mine";
        write_file_atomically(folder / "a.txt", "new\n");
        CHECK(content_of(folder / name) == "mine");
    }
    CHECK(folder.count_files() == 7);
}

TEST_CASE("two replacements of one file do not disturb each other") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "a.txt", [&](OutputFile& first) {
        first.write("first\n");
        write_file_atomically(folder / "a.txt", "second\n");
        CHECK(content_of(folder / "a.txt") == "second\n");
    });
    CHECK(content_of(folder / "a.txt") == "first\n");
    CHECK(folder.count_files() == 1);
}

TEST_CASE("what is no file is not replaced") {
    CHECK_THROWS_WITH(write_file_atomically(std::filesystem::path("/dev/null"), "text"),
                      Contains("'/dev/null'") && Contains("not a regular"));
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a file goes where its directory is, even if another one stands at its path") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "out");
    const OpenDirectory out(folder / "out");
    std::filesystem::rename(folder / "out", folder / "moved");
    std::filesystem::create_directory(folder / "out");
    std::ofstream(folder / "out/a.txt") << "mine";
    write_file_atomically(out / "a.txt", "new\n");
    OutputFile(out / "b.txt").write("new\n");
    CHECK(content_of(folder / "moved/a.txt") == "new\n");
    CHECK(content_of(folder / "moved/b.txt") == "new\n");
    CHECK(content_of(folder / "out/a.txt") == "mine");
    CHECK_FALSE(std::filesystem::exists(folder / "out/b.txt"));
}

TEST_CASE("what a killed holder of a directory has left over is removed by the next one, and nothing else") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "out");
    const std::vector<std::string> foreign{".ljmd-0123456789abcdef", ".ljmd-locked-", ".ljmd-locked-0123456789abcdeg",
                                           ".ljmd-locked-0123456789abcdef0", "a.txt"};
    for (const std::string& name : foreign) {
        std::ofstream(folder / "out" / name) << "mine";
    }
    std::ofstream(folder / "out/.ljmd-locked-0123456789abcdef") << "left over";
    const DirectoryLock lock(folder / "out");
    for (const std::string& name : foreign) {
        CHECK(std::filesystem::exists(folder / "out" / name));
    }
    CHECK_FALSE(std::filesystem::exists(folder / "out/.ljmd-locked-0123456789abcdef"));
    const ReplacementFile file(lock.directory() / "a.txt");
    CHECK_THAT(file.growing().name, StartsWith(".ljmd-locked-"));
    CHECK_THAT(ReplacementFile(folder / "out/a.txt").growing().name, !StartsWith(".ljmd-locked-"));
    CHECK_THAT(ReplacementFile(lock.directory().made_within("in") / "a").growing().name, StartsWith(".ljmd-locked-"));
    CHECK(file.growing().directory.is_held_alone());
}
