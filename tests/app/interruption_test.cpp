#include "ljmd/app/interruption.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <functional>

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// What becomes of a process that does this: its exit code, or minus the signal that ended it. A process that was asked
/// to stop stays so, which must not be this one.
int end_of(const std::function<bool()>& body) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::_exit(body() ? 0 : 1);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("a signal asks to stop, and says with what exit code") {
    const int number = GENERATE(SIGINT, SIGTERM, SIGHUP);
    CHECK(end_of([number] {
              heed_signals();
              const bool before = Interruption().wanted();
              std::raise(number);
              const Interruption asked;
              try {
                  asked.stop(7, "out");
              } catch (const Interrupted& stopped) {
                  return !before && asked.wanted() && signal_received() == number &&
                         stopped.exit_code() == 128 + number &&
                         std::string(stopped.what()).find("after step 7 by SIG") != std::string::npos;
              }
          }) == 0);
}

TEST_CASE("the second signal of a kind ends the program at once") {
    CHECK(end_of([] {
              heed_signals();
              std::raise(SIGINT);
              std::raise(SIGINT);
              return true;
          }) == -SIGINT);
}

TEST_CASE("a signal that was ignored before stays so") {
    CHECK(end_of([] {
              std::signal(SIGHUP, SIG_IGN);
              heed_signals();
              std::raise(SIGHUP);
              return signal_received() == 0;
          }) == 0);
}

TEST_CASE("a run has to stop when its wall time is over, and only then") {
    CHECK_FALSE(Interruption().wanted());
    CHECK_FALSE(Interruption(1e9).wanted());
    const Interruption over(0.0);
    CHECK(over.wanted());
    try {
        over.stop(12, "runs/argon");
    } catch (const Interrupted& stopped) {
        CHECK(stopped.exit_code() == 75);
        CHECK_THAT(stopped.what(), Contains("after step 12") && Contains("ljmd resume runs/argon"));
    }
}
