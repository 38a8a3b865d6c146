#include "io/files/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include "catch.hpp"

#include "io/written_file.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
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

TEST_CASE("an input that cannot be looked at is an error of the input") {
    const ScratchDirectory folder;
    const fs::path circle = folder.path() / "circle";
    fs::create_symlink("circle", circle);
    CHECK(input_is_directory(folder.path()));
    CHECK_FALSE(input_is_directory(folder.path() / "none"));
    CHECK(input_is_there(circle));
    CHECK_FALSE(input_is_there(folder.path() / "none"));
    const std::string cause = "': Too many levels of symbolic links";
    CHECK(data_error([&] { static_cast<void>(input_is_directory(circle)); }) ==
          "cannot look at '" + circle.string() + cause);
    CHECK(data_error([&] { static_cast<void>(input_is_there(circle / "name")); }) ==
          "cannot look at '" + (circle / "name").string() + cause);
}

TEST_CASE("a file that is open but has no name any more is read") {
    WrittenFile file("some text\n");
    const int descriptor = ::open(file.path().c_str(), O_RDONLY | O_CLOEXEC);
    fs::remove(file.path());
    CHECK(read_input("/dev/fd/" + std::to_string(descriptor)) == "some text\n");
    ::close(descriptor);
}

TEST_CASE("files that the kernel makes up are not opened: some are waited for") {
    CHECK(why_unreadable(WrittenFile("").path()).empty());
    const ScratchDirectory folder;
    fs::create_symlink("/proc/self/status", folder.path() / "link");
    for (const fs::path& path : {fs::path("/proc/self/status"), fs::path("/proc/kmsg"), folder.path() / "link"}) {
        if (fs::exists(path)) {
            CHECK_THAT(why_unreadable(path), Contains("is made up by the kernel"));
        }
    }
}

TEST_CASE("what is not read is named") {
    CHECK(data_error([] { static_cast<void>(open_input("no/such.file")); }) == "no/such.file: no such file");
}

TEST_CASE("what a file is that does not begin as a text does, is told") {
    using namespace std::string_view_literals;
    CHECK(why_no_text("").empty());
    CHECK(why_no_text("864\r\nLattice").empty());
    CHECK(why_no_text("a line without end").empty());
    CHECK(why_no_text("\xEF\xBB\xBF"
                      "864\n")
              .empty());
    CHECK_THAT(why_no_text("\x89HDF\r\n\x1a\n"sv), Contains("is an HDF5 file"));
    for (const std::string_view wide : {"\xFF\xFE\x38\0"sv, "\xFE\xFF\0\x38"sv, "8\0006\0"sv, "\0008\0006"sv}) {
        CHECK_THAT(why_no_text(wide), Contains("UTF-16"));
    }
    CHECK_THAT(why_no_text("864\rLattice\r"), Contains("CR alone"));
    CHECK_THAT(why_no_text("\x1f\x8b\x08"), Contains("gzip"));
    CHECK_THAT(why_no_text("\xFD"
                           "7zXZ\0"sv),
               Contains("xz"));
    CHECK_THAT(why_no_text("BZh91AY&SY"), Contains("bzip2"));
    CHECK_THAT(why_no_text("\x28\xB5\x2F\xFD"sv), Contains("zstd"));
    CHECK_THAT(why_no_text("PK\x03\x04"sv), Contains("zip"));
    CHECK_THAT(why_no_text("CDF\x01"sv), Contains("NetCDF"));
    CHECK(why_no_text("some\0thing"sv).empty());
}
