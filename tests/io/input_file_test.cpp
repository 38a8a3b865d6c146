#include "ljmd/io/input_file.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <string>

#include "io/written_file.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

TEST_CASE("only regular files are read, and links to them") {
    const ScratchDirectory folder;
    const fs::path pipe = folder.path() / "pipe";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    fs::create_symlink("pipe", folder.path() / "link to a pipe");
    fs::create_symlink("nowhere", folder.path() / "link to nothing");
    fs::create_symlink("itself", folder.path() / "itself");
    CHECK(why_unreadable(pipe) == "is a pipe, not a regular file");
    CHECK(why_unreadable(folder.path() / "link to a pipe") == "is a pipe, not a regular file");
    CHECK(why_unreadable(folder.path() / "link to nothing") == "no such file");
    CHECK(why_unreadable(folder.path() / "itself") == "cannot be read: Too many levels of symbolic links");
    CHECK(why_unreadable(folder.path()) == "is a directory, not a regular file");
    CHECK(why_unreadable("/dev/zero") == "is a device or a socket, not a regular file");

    const WrittenFile file("some text\n");
    fs::create_symlink(file.path(), folder.path() / "link");
    CHECK(why_unreadable(folder.path() / "link").empty());
    std::string line;
    std::ifstream stream = open_input(folder.path() / "link");
    CHECK(std::getline(stream, line));
    CHECK(line == "some text");
}

TEST_CASE("what is not read is named") {
    CHECK(data_error([] { static_cast<void>(open_input("no/such.file")); }) == "no/such.file: no such file");
}
