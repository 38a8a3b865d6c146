#include "ljmd/run/output_guard.hpp"

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
