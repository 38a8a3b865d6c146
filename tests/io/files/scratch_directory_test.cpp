#include "io/files/scratch_directory.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>
#include "catch.hpp"

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

TEST_CASE("a scratch directory is gone, too, when the program is killed, or ends without leaving the scope") {
    const int number = GENERATE(0, SIGKILL, SIGINT, SIGQUIT);
    Pipe told;
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(number, SIG_DFL);  // not Catch's
        const ScratchDirectory scratch;
        std::ofstream(scratch.path() / "file") << "text";
        const std::string path = scratch.path().string();
        [[maybe_unused]] const auto written = ::write(told.write_end(), path.data(), path.size());
        ::kill(::getpid(), number);  // 0 is none
        ::_exit(0);
    }
    told.close_write_end();
    std::string path(1000, '\0');
    const ssize_t length = ::read(told.read_end(), path.data(), path.size());
    REQUIRE(length > 0);
    path.resize(static_cast<std::size_t>(length));
    REQUIRE(::waitpid(child, nullptr, 0) == child);
    for (int moment = 0; std::filesystem::exists(path) && moment < 3000; ++moment) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
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
