#include "ljmd/core/build_info.hpp"

#include <fstream>
#include <regex>
#include <string>
#include "catch.hpp"

using ljmd::build_info;

TEST_CASE("the version is the one in cmake/VERSION") {
    std::ifstream file(LJMD_TEST_DATA "/../../cmake/VERSION");
    std::string version;
    REQUIRE(file >> version);
    CHECK(build_info().version == version);
}

TEST_CASE("the commit is a full hash, with a mark if files were changed, or unknown") {
    CAPTURE(build_info().commit);
    CHECK(std::regex_match(build_info().commit, std::regex("unknown|[0-9a-f]{40}(-dirty)?")));
}

TEST_CASE("the compiler that is named is the one that compiles") {
#if defined(__clang__)
    CHECK_THAT(build_info().compiler, Catch::Matchers::Contains("Clang"));
    const std::string major = std::to_string(__clang_major__);
#else
    CHECK(build_info().compiler == "GNU");
    const std::string major = std::to_string(__GNUC__);
#endif
    CHECK_THAT(build_info().compiler_version, Catch::Matchers::StartsWith(major + "."));
}

TEST_CASE("the flags hold what decides numbers, and no warnings") {
    const std::string flags = " " + build_info().flags + " ";
    CHECK_THAT(flags, Catch::Matchers::Contains(" -ffp-contract=off "));
    CHECK_THAT(flags, Catch::Matchers::Contains(" -O"));
    CHECK_THAT(flags, !Catch::Matchers::Contains(" -W"));
    CHECK_FALSE(build_info().build_type.empty());
}
