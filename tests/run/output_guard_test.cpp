#include "run/output_guard.hpp"

#include <sys/stat.h>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

TEST_CASE("outputs that are there are found, files and links alike, and nothing is changed") {
    const TemporaryFolder folder;
    CHECK(existing_outputs(folder / "none", {"a"}, "Nothing was run").empty());
    std::ofstream(folder / "a") << "mine";
    fs::create_symlink("nowhere", folder / "b");
    const std::vector<fs::path> found = existing_outputs(folder / "", {"c", "b", "a"}, "Nothing was run");
    CHECK(found == std::vector<fs::path>{folder / "b", folder / "a"});
    CHECK_NOTHROW(require_no_outputs(folder / "", {"c"}, false, "Nothing was run"));
    CHECK_NOTHROW(require_no_outputs(folder / "", {"a", "b"}, true, "Nothing was run"));
    CHECK_THROWS_AS(require_no_outputs(folder / "", {"c", "b"}, false, "Nothing was run"), InputError);
    CHECK_THROWS_WITH(require_no_outputs(folder / "", {"a"}, false, "Nothing was run"),
                      Contains("/a is there already. Nothing was run.\n  choose another directory, or replace it") &&
                          !Contains("--"));
    CHECK(content_of(folder / "a") == "mine");
    CHECK(folder.count_files() == 2);
}

TEST_CASE("a refusal tells commands by which options something else is chosen, and others what alone") {
    const OutputRefused refused("it is there. Nothing was run.",
                                {another_directory, {"or replace it", " with --force"}});
    CHECK(refused.what() == std::string("it is there. Nothing was run.\n  choose another directory, or replace it"));
    CHECK(refused.for_commands() ==
          "it is there. Nothing was run.\n  choose another directory with --out, or replace it with --force");
}

TEST_CASE("what is no file is in the way, with force or without") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a");
    REQUIRE(mkfifo((folder / "b").c_str(), 0600) == 0);
    for (const char* name : {"a", "b"}) {
        for (const bool force : {false, true}) {
            CHECK_THROWS_WITH(require_no_outputs(folder / "", {name}, force, "Nothing was run"),
                              Contains(std::string("/") + name + " is in the way: ") && Contains("Nothing was run."));
        }
    }
    CHECK(folder.count_files() == 2);
}

TEST_CASE("a directory that is none, and one whose path leaves no room for names, are refused") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "mine";
    CHECK_THROWS_WITH(existing_outputs(folder / "a", {}, "Nothing was run"),
                      Contains("exists and is not a directory. Nothing was run."));
    CHECK_THROWS_WITH(existing_outputs(std::string(4090, 'x'), {"a"}, "Nothing was run"),
                      Contains(" is too long: files in it cannot be named. Nothing was run."));
}

TEST_CASE("a name for outputs fits into a file system, and ends between two characters") {
    CHECK(output_name("argon", "-lammps") == "argon-lammps");
    CHECK(output_name(std::string(248, 'x'), "-lammps") == std::string(248, 'x') + "-lammps");
    CHECK(output_name(std::string(255, 'x'), "-lammps") == std::string(248, 'x') + "-lammps");
    CHECK(output_name(std::string(247, 'x') + "\u00e9\u00e9", "-lammps") == std::string(247, 'x') + "-lammps");
}

TEST_CASE("the directory of a run is told by its record, whatever that is") {
    const TemporaryFolder folder;
    CHECK_NOTHROW(require_no_run(folder / "", "Nothing was run"));
    fs::create_symlink("nowhere", folder / "run.json");
    CHECK_THROWS_WITH(require_no_run(folder / "", "Nothing was run"),
                      Contains("is the directory of a run, whose files stay as they are. Nothing was run."));
}

TEST_CASE(
    "a file that is named takes a free place, with force that of another one, and by its mark that of one of ours") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    write_output(file, {}, "first ours");
    CHECK_THROWS_WITH(write_output(file, {}, "second"), Contains("/a is there already. Nothing was written.\n  choose "
                                                                 "another name, or replace it"));
    CHECK_THROWS_WITH(write_output(file, {.mark = "mark"}, "second"),
                      Contains("there already, and was not written by "));
    CHECK(content_of(file) == "first ours");
    write_output(file, {.mark = "ours"}, "second");
    write_output(file, {.force = true}, "third");
    CHECK(content_of(file) == "third");
    std::ofstream(file) << std::string(5000, ' ') << "ours";
    CHECK_THROWS_AS(write_output(file, {.mark = "ours"}, "fourth"), OutputRefused);
    CHECK(folder.count_files() == 1);
}

TEST_CASE("a link in the place of a named file is not followed, and replaced by force alone") {
    const TemporaryFolder folder;
    std::ofstream(folder / "mine") << "ours";
    for (const char* target : {"mine", "nowhere"}) {
        fs::create_symlink(target, folder / "a");
        CHECK_THROWS_WITH(write_output(folder / "a", {.mark = "ours"}, "new"),
                          Contains(", a link, which is not followed"));
        write_output(folder / "a", {.force = true}, "new");
        CHECK(fs::is_regular_file(fs::symlink_status(folder / "a")));
        fs::remove(folder / "a");
    }
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    for (const char* target : {"pipe", "."}) {
        fs::create_symlink(target, folder / "a");
        CHECK_THROWS_WITH(write_output(folder / "a", {.force = true}, "new"), Contains("/a is in the way: "));
        fs::remove(folder / "a");
    }
    CHECK(content_of(folder / "mine") == "ours");
    CHECK(folder.count_files() == 2);
}

TEST_CASE("what somebody puts in the place of a named file while it grows stays there") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    CHECK_THROWS_AS(write_output(file, {},
                                 [&](OutputFile& growing) {
                                     growing.write("ours");
                                     std::ofstream(file) << "mine";
                                 }),
                    OutputRefused);
    CHECK(content_of(file) == "mine");
    CHECK(folder.count_files() == 1);
}

TEST_CASE("a named file that cannot be written leaves the old one and nothing else") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    std::ofstream(file) << "mine";
    {
        const FileSizeLimit limit(100);
        CHECK_THROWS_AS(write_output(file, {.force = true}, std::string(1000, 'x')), FileError);
    }
    CHECK_THROWS_AS(write_output(folder / "", {.force = true}, "new"), InputError);
    CHECK(content_of(file) == "mine");
    CHECK(folder.count_files() == 1);
}
