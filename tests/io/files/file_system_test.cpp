#include "io/files/file_system.hpp"

#include <fstream>
#include <string>
#include "catch.hpp"

#include "io/files/scratch_directory.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// A folder with a file of 5 bytes, a folder, and links: to the file, to nothing, and in a circle.
struct Folder {
    ScratchDirectory scratch;
    fs::path path = scratch.path();

    Folder() {
        std::ofstream(path / "file") << "12345";
        fs::create_directory(path / "folder");
        fs::create_symlink("file", path / "link");
        fs::create_symlink("nowhere", path / "broken");
        fs::create_symlink("circle", path / "circle");
    }
};

/// What a call says that fails.
template <class Call>
std::string file_error(const Call& call) {
    try {
        call();
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("what is there is told, at the end of links or of the name itself") {
    const Folder in;
    CHECK(files::exists(in.path / "file"));
    CHECK(files::exists(in.path / "link"));
    CHECK_FALSE(files::exists(in.path / "broken"));
    CHECK_FALSE(files::exists(in.path / "nothing"));
    CHECK_FALSE(files::exists(in.path / "file" / "below"));
    CHECK(files::is_taken(in.path / "broken"));
    CHECK(files::is_taken(in.path / "circle"));
    CHECK_FALSE(files::is_taken(in.path / "nothing"));
    CHECK(files::type_of(in.path / "link") == fs::file_type::symlink);
    CHECK(files::type_of(in.path / "folder") == fs::file_type::directory);
    CHECK(files::is_directory(in.path));
    CHECK_FALSE(files::is_directory(in.path / "link"));
    CHECK_FALSE(files::is_directory(in.path / "broken"));
    CHECK(files::is_no_directory(in.path / "link"));
    CHECK_FALSE(files::is_no_directory(in.path));
    CHECK_FALSE(files::is_no_directory(in.path / "broken"));
    CHECK(files::is_regular_file(in.path / "link"));
    CHECK_FALSE(files::is_regular_file(in.path));
    CHECK(files::size_of(in.path / "link") == 5U);
    CHECK(files::size_of(in.path / "folder") == std::nullopt);
    CHECK(files::size_of(in.path / "broken") == std::nullopt);
    CHECK(files::are_same(in.path / "link", in.path / "file"));
    CHECK_FALSE(files::are_same(in.path / "link", in.path / "folder"));
    CHECK_FALSE(files::are_same(in.path / "nothing", in.path / "file"));
    CHECK(files::read_link(in.path / "link") == "file");
    const auto all = files::list(in.path);
    REQUIRE(all.size() == 5);
    CHECK(all.front() == in.path / "broken");
    CHECK(all.back() == in.path / "link");
}

TEST_CASE("what the file system does not answer is a file error with path and cause") {
    const Folder in;
    const fs::path circle = in.path / "circle";
    const fs::path below = circle / "name";
    const std::string cause = "': Too many levels of symbolic links";
    const std::string unseen = "cannot look at '" + circle.string() + cause;
    CHECK(file_error([&] { static_cast<void>(files::exists(circle)); }) == unseen);
    CHECK(file_error([&] { static_cast<void>(files::size_of(circle)); }) == unseen);
    CHECK(file_error([&] { static_cast<void>(files::is_no_directory(circle)); }) == unseen);
    CHECK(file_error([&] { static_cast<void>(files::is_directory(circle)); }) == unseen);
    CHECK(file_error([&] { static_cast<void>(files::is_regular_file(circle)); }) == unseen);
    CHECK(file_error([&] { static_cast<void>(files::are_same(circle, in.path)); }) == unseen);
    CHECK(file_error([&] { static_cast<void>(files::is_taken(below)); }) ==
          "cannot look at '" + below.string() + cause);
    CHECK(file_error([&] { static_cast<void>(files::type_of(below)); }) == "cannot look at '" + below.string() + cause);
    CHECK(file_error([&] { static_cast<void>(files::list(circle)); }) ==
          "cannot read the directory '" + circle.string() + cause);
    CHECK_THAT(file_error([&] { static_cast<void>(files::list(in.path / "nothing")); }), Contains("No such file"));
    CHECK_THAT(file_error([&] { static_cast<void>(files::read_link(in.path / "file")); }),
               Contains("cannot read the link"));
    CHECK_THAT(file_error([&] { files::create_directories(in.path / "file" / "folder"); }),
               Contains("cannot create the directory"));
    CHECK_THAT(file_error([&] { files::remove(in.path); }), Contains("cannot remove '" + in.path.string()));
    CHECK_THAT(file_error([&] { files::rename(in.path / "nothing", in.path / "file"); }),
               Contains("cannot replace '" + (in.path / "file").string()));
}

TEST_CASE("folders are made and removed") {
    const Folder in;
    files::create_directories(in.path / "a" / "b");
    files::create_directories(in.path / "a" / "b");
    CHECK(files::is_directory(in.path / "a" / "b"));
    files::try_to_remove(in.path / "a");  // is not empty
    CHECK(files::is_directory(in.path / "a"));
    files::remove(in.path / "a" / "b");
    files::remove(in.path / "a" / "b");
    files::rename(in.path / "file", in.path / "renamed");
    CHECK(files::size_of(in.path / "renamed") == 5U);
    files::try_to_remove_all(in.path / "a");
    CHECK_FALSE(files::exists(in.path / "a"));
}

TEST_CASE("a place has one canonical path, however it is reached, and before it exists") {
    const ScratchDirectory scratch;
    const fs::path real = fs::canonical(scratch.path()) / "real";
    fs::create_directory(real);
    fs::create_directory_symlink("real", scratch.path() / "link");
    for (const char* way : {"real", "real/", "link", "link/", "link/.", "link/../real", "./real//"}) {
        CAPTURE(way);
        CHECK(files::canonical(scratch.path() / way) == real);
    }
    CHECK(files::canonical(scratch.path() / "link/out/") == real / "out");
    CHECK(files::canonical("some") == fs::current_path() / "some");
    fs::create_symlink("circle", scratch.path() / "circle");
    CHECK_THAT(file_error([&] { static_cast<void>(files::canonical(scratch.path() / "circle")); }),
               Contains("cannot find") && Contains("circle"));
}

TEST_CASE("paths are found without a working directory, where they do not need one") {
    const fs::path before = fs::current_path();
    {
        const ScratchDirectory gone;
        fs::current_path(gone.path());
    }
    CHECK(files::absolute("/some/where") == "/some/where");
    CHECK(files::absolute("").empty());
    const std::string words = file_error([] { static_cast<void>(files::absolute("some")); });
    fs::current_path(before);
    CHECK(words == "cannot find 'some' from the working directory: No such file or directory");
    CHECK(files::absolute("some") == before / "some");
}
