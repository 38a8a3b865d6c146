#include "ljmd/io/scratch_directory.hpp"

#include <catch2/catch.hpp>
#include <fstream>

using namespace ljmd;

TEST_CASE("a scratch directory is new, and gone with its files at the end") {
    std::filesystem::path path;
    {
        const ScratchDirectory one;
        const ScratchDirectory other;
        CHECK(one.path() != other.path());
        path = one.path();
        CHECK(std::filesystem::is_empty(path));
        std::ofstream(path / "file") << "text";
    }
    CHECK_FALSE(std::filesystem::exists(path));
}
