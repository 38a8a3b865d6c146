#include "ljmd/io/scratch_directory.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "core/environment_guard.hpp"
#include "ljmd/core/errors.hpp"

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

TEST_CASE("a scratch directory is made nowhere else than among the temporary files of the system") {
    const ScratchDirectory scratch;
    std::ofstream(scratch.path() / "file") << "text";
    const test::EnvironmentGuard wrong("TMPDIR", (scratch.path() / GENERATE("absent", "file")).string());
    CHECK_THROWS_AS(ScratchDirectory(), FileError);
    CHECK_THROWS_WITH(ScratchDirectory(), Catch::StartsWith("no directory for temporary files: ") &&
                                              Catch::EndsWith("; does TMPDIR name one?"));
}
