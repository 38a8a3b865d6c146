#include "io/files/program_module.hpp"

#include <dlfcn.h>

#include "catch.hpp"

#include "io/files/file_system.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// A library that every program has.
std::filesystem::path library_of_the_system() {
    Dl_info info{};
    REQUIRE(::dladdr(::dlsym(RTLD_DEFAULT, "fmod"), &info) != 0);
    return info.dli_fname;
}

}  // namespace

TEST_CASE("this program is the one that runs") {
    CHECK(files::exists(this_program()));
    CHECK(this_program().filename() == "test_io");
}

TEST_CASE("a module is a file beside the program, or in a folder of the libraries") {
    const ProgramModule beside("a library", "packages", "test_io");
    CHECK(beside.path() == this_program());
    CHECK(beside.is_there());
    const ProgramModule missing("a library", "this and that", "ljmd_nothing.so");
    CHECK_FALSE(missing.is_there());
    CHECK(missing.path().parent_path().filename() == "ljmd");
    CHECK_THROWS_AS(missing.function<void()>("any"), InputError);
    CHECK_THROWS_WITH(missing.function<void()>("any"),
                      "this ljmd was built without a library: there is no " + missing.path().string() +
                          "; install it (Debian: apt-get install this and that) and build again");
}

TEST_CASE("a module offers a function, and what is none is told with the reason of the system") {
    const ProgramModule found("mathematics", "packages", library_of_the_system());
    CHECK(found.function<double(double, double)>("fmod")(5.0, 3.0) == 2.0);
    CHECK_THROWS_WITH(found.function<void()>("ljmd_nothing"), Contains("is not the part of ljmd for mathematics"));
    const std::string source = LJMD_INPUTS "/examples/first.toml";
    const ProgramModule damaged("mathematics", "packages", source);
    CHECK_THROWS_AS(damaged.function<void()>("fmod"), InputError);
    CHECK_THROWS_WITH(
        damaged.function<void()>("fmod"),
        Contains("the part of ljmd for mathematics, " + source + ", cannot be loaded: ") && Contains("ELF"));
}
