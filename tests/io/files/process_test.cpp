#include "io/files/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "io/files/pipe.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

namespace {

/// A program of a few lines of shell.
fs::path script(const fs::path& path, const std::string& text) {
    std::ofstream(path) << "#!/bin/sh\n" << text << '\n';
    fs::permissions(path, fs::perms::owner_all);
    return path;
}

}  // namespace

TEST_CASE("a program is found in PATH, or where its name says") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "some-program", "exit 0");
    std::ofstream(folder / "no-program") << "text";
    fs::create_directory(folder / "directory");
    const std::string here = program.parent_path().string();
    const EnvironmentGuard path("PATH", "/nowhere:" + here + "::/bin");
    CHECK(find_program("some-program") == program);
    CHECK(find_program(program.string()) == program);
    CHECK(find_program("sh") == "/bin/sh");
    for (const char* absent : {"", "such-a-program-is-not-there", "no-program", "directory", "/", "/bin/", "bin/sh"}) {
        INFO(absent);
        CHECK_FALSE(find_program(absent).has_value());
    }
    CHECK_FALSE(find_program((folder / "no-program").string()).has_value());
    const EnvironmentGuard nothing("PATH", "");
    CHECK_FALSE(find_program("sh").has_value());
}

TEST_CASE("a program runs in its directory, and what it says goes to a file") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "program", R"(echo "$1|$2|$#"; pwd; cat; echo bad >&2; exit 7)");
    const fs::path directory = folder / "inner";
    fs::create_directory(directory);
    // Nothing in the arguments means anything to a shell.
    const int status =
        run_process({.program = program, .arguments = {"a b; $HOME", "*"}, .directory = directory, .output = "said"});
    CHECK(status == 7);
    CHECK(content_of(directory / "said") == "a b; $HOME|*|2\n" + fs::canonical(directory).string() + "\nbad\n");
}

TEST_CASE("a program has our environment and what is added to it") {
    const TemporaryFolder folder;
    const EnvironmentGuard kept("LJMD_TEST_KEPT", "ours");
    const EnvironmentGuard replaced("LJMD_TEST_REPLACED", "ours");
    const fs::path program = script(folder / "program", "env");
    const fs::path directory = program.parent_path();
    CHECK(run_process({.program = program,
                       .directory = directory,
                       .output = "said",
                       .environment = {{"LJMD_TEST_REPLACED", "new"}, {"OMP_NUM_THREADS", "3"}}}) == 0);
    const std::string said = content_of(directory / "said");
    for (const char* line : {"LJMD_TEST_KEPT=ours\n", "LJMD_TEST_REPLACED=new\n", "OMP_NUM_THREADS=3\n"}) {
        CHECK_THAT(said, Catch::Contains(line));
    }
    CHECK_THAT(said, !Catch::Contains("LJMD_TEST_REPLACED=ours"));
    CHECK(run_process({.program = program, .directory = directory, .output = "less", .without = {"LJMD_TEST_"}}) == 0);
    CHECK_THAT(content_of(directory / "less"), !Catch::Contains("LJMD_TEST_") && Catch::Contains("PATH="));
}

TEST_CASE("a signal that ends a program shows in its status, also one that we ignore") {
    const TemporaryFolder folder;
    const fs::path killed = script(folder / "killed", "kill -9 $$");
    const fs::path directory = killed.parent_path();
    CHECK(run_process({.program = killed, .directory = directory, .output = "said"}) == 128 + SIGKILL);
    void (*before)(int) = std::signal(SIGPIPE, SIG_IGN);
    const fs::path piped = script(folder / "piped", "kill -PIPE $$");
    const int status = run_process({.program = piped, .directory = directory, .output = "said"});
    std::signal(SIGPIPE, before);
    CHECK(status == 128 + SIGPIPE);
}

TEST_CASE("a program has no signal blocked, no handler of ours, and ignores what we were told to ignore") {
    const TemporaryFolder folder;
    const fs::path program = script(
        folder / "program", "grep SigBlk /proc/self/status; kill -HUP $$; echo here; kill -USR2 $$; echo here, too");
    void (*handler)(int) = std::signal(SIGUSR2, [](int) {});
    void (*ignored)(int) = std::signal(SIGHUP, SIG_IGN);
    sigset_t blocked;
    sigset_t before;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigprocmask(SIG_BLOCK, &blocked, &before);
    const int status = run_process({.program = program, .directory = folder / "", .output = "said"});
    sigprocmask(SIG_SETMASK, &before, nullptr);
    std::signal(SIGUSR2, handler);
    std::signal(SIGHUP, ignored);
    CHECK(status == 128 + SIGUSR2);
    CHECK(content_of(folder / "said") == "SigBlk:\t0000000000000000\nhere\n");
}

TEST_CASE("a program reads what it is given, and no program inherits the pipe of another") {
    const TemporaryFolder folder;
    Pipe pipe;
    ChildProcess reader({.program = "/bin/cat", .directory = folder / "", .output = "said", .input = pipe.read_end()});
    ChildProcess other({.program = "/bin/sleep", .arguments = {"60"}, .directory = folder / "", .output = "nothing"});
    REQUIRE(::write(pipe.write_end(), "text", 4) == 4);
    pipe.close_write_end();
    CHECK(reader.wait() == 0);
    CHECK(content_of(folder / "said") == "text");
    other.signal(SIGKILL);
    CHECK(other.wait() == 128 + SIGKILL);
}

TEST_CASE("a program ends with the process that started it, however that ends") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "program", "echo here > begun; read word < never-written");
    REQUIRE(::mkfifo((folder / "never-written").c_str(), 0600) == 0);
    int alive[2] = {};  // inherited by both, so its end is seen when both are gone
    REQUIRE(::pipe(alive) == 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        const ChildProcess child({.program = program, .directory = folder / "", .output = "said"});
        while (!fs::exists(folder / "begun")) {
            ::usleep(1000);
        }
        std::raise(SIGKILL);
    }
    ::close(alive[1]);
    pollfd ended{.fd = alive[0], .events = POLLIN, .revents = 0};
    constexpr int patience = 900'000;  // [ms]
    CHECK(::poll(&ended, 1, patience) == 1);
    ::kill(parent, SIGKILL);
    CHECK(::waitpid(parent, nullptr, 0) == parent);
    ::close(::open((folder / "never-written").c_str(), O_RDWR | O_NONBLOCK));  // ends a program that lives on
    ::close(alive[0]);
}

TEST_CASE("what cannot be started is an error that says what and where") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "program", "exit 0");
    const fs::path here = program.parent_path();
    const auto refused = [&](const Process& process) {
        CHECK_THROWS_AS(static_cast<void>(run_process(process)), FileError);
        CHECK_THROWS_WITH(static_cast<void>(run_process(process)),
                          Catch::StartsWith("cannot start '" + process.program.string() + "' in '"));
    };
    refused({.program = folder / "absent", .directory = here, .output = "said"});
    refused({.program = program, .directory = folder / "absent", .output = "said"});
    refused({.program = program, .directory = here, .output = "absent/said"});
}

TEST_CASE("a program that runs beside this one tells when it has ended, and takes signals") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "program", R"(while [ ! -e go ]; do sleep 0.01; done; exit 3)");
    const Process process{.program = program, .directory = folder / "", .output = "said"};
    ChildProcess child(process);
    CHECK_FALSE(child.ended());
    std::ofstream(folder / "go") << "now";
    CHECK(child.wait() == 3);
    CHECK(child.ended() == 3);
    child.signal(SIGTERM);  // nobody is hit

    fs::remove(folder / "go");
    ChildProcess other(process);
    other.signal(SIGTERM);
    CHECK(other.wait() == 128 + SIGTERM);
}

TEST_CASE("a program with a group of its own is in another one than this") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "program", "cut -d' ' -f5 /proc/$$/stat");
    for (const bool own_group : {false, true}) {
        REQUIRE(run_process({.program = program, .directory = folder / "", .output = "said", .own_group = own_group}) ==
                0);
        CHECK((std::stol(content_of(folder / "said")) == getpgrp()) != own_group);
    }
}

TEST_CASE("what a kept program has started ends with it, when it is stopped, and when this process is killed") {
    const TemporaryFolder folder;
    // Children that have left it: in a session of their own, in the background, deaf to signals. All hold the pipe
    // open.
    const fs::path program = script(folder / "program", R"(trap '' HUP INT QUIT TERM
setsid sh -c 'trap "" HUP INT QUIT TERM; (sleep 100000 & sleep 100000) & sleep 100000' &
(setsid sleep 100000 &)
echo here > begun
while [ ! -e go ]; do sleep 0.01; done)");
    enum class End { its_own, stopped, killed };
    for (const End end : {End::its_own, End::stopped, End::killed}) {
        CAPTURE(static_cast<int>(end));
        fs::remove(folder / "begun");
        fs::remove(folder / "go");
        int alive[2] = {};
        REQUIRE(::pipe(alive) == 0);
        const pid_t parent = ::fork();
        if (parent == 0) {
            ChildProcess child({.program = program, .directory = folder / "", .output = "said", .kept = true});
            while (!fs::exists(folder / "begun")) {
                ::usleep(1000);
            }
            if (end == End::killed) {
                std::raise(SIGKILL);
            } else if (end == End::stopped) {
                child.stop();
            } else {
                std::ofstream(folder / "go") << "now";
            }
            ::_exit(child.wait());
        }
        ::close(alive[1]);
        int status = 0;
        CHECK(::waitpid(parent, &status, 0) == parent);
        pollfd ended{.fd = alive[0], .events = POLLIN, .revents = 0};
        // All have ended when a kept program has, so that nothing is waited for; but for the death of this process.
        constexpr int patience = 900'000;  // [ms]
        CHECK(::poll(&ended, 1, end == End::killed ? patience : 0) == 1);
        CHECK((end == End::killed ? WIFSIGNALED(status) : WIFEXITED(status)));
        CHECK((end == End::killed || WEXITSTATUS(status) == (end == End::stopped ? 128 + SIGKILL : 0)));
        ::close(alive[0]);
    }
}

TEST_CASE("a program that cannot be kept is told of, and one that is kept tells its exit status") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(
        ChildProcess({.program = folder / "absent", .directory = folder / "", .output = "said", .kept = true}),
        FileError);
    const fs::path program = script(folder / "program", "echo out; echo error >&2; exit 7");
    CHECK(run_process(
              {.program = program, .directory = folder / "", .output = "said", .errors = "errors", .kept = true}) == 7);
    CHECK(content_of(folder / "said") == "out\n");
    CHECK(content_of(folder / "errors") == "error\n");
    const fs::path killed = script(folder / "killed", "kill -TERM $$");
    CHECK(run_process({.program = killed, .directory = folder / "", .output = "said", .kept = true}) == 128 + SIGTERM);
}

TEST_CASE("a program takes over the process: its exit status, and what is added to the environment") {
    const TemporaryFolder folder;
    const fs::path program = script(folder / "program", R"(test "$1|$LJMD_TOLD" = "a b|yes" && exit 23)");
    const pid_t child = fork();
    if (child == 0) {
        become_program(program, {"a b"}, {{"LJMD_TOLD", "yes"}});
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WEXITSTATUS(status) == 23);
    CHECK_THROWS_AS(become_program(folder / "absent", {}, {}), FileError);
}
