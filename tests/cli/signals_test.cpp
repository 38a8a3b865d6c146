#include "cli/signals.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>
#include "catch.hpp"

using namespace ljmd;

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
    const int number = GENERATE(SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGXCPU);
    CHECK(end_of([number] {
              install_stop_handlers();
              const Interruption interruption = until_signal();
              const bool before = interruption.wanted();
              std::raise(number);
              try {
                  interruption.stop(7, "out");
              } catch (const Interrupted& stopped) {
                  return !before && interruption.wanted() && stop_signal()->signal == number &&
                         stopped.exit_code() == 128 + number &&
                         std::string(stopped.what()).find("after step 7 by SIG") != std::string::npos;
              }
          }) == 0);
}

TEST_CASE("the second signal of a kind that a person sends ends the program at once") {
    const int number = GENERATE(SIGINT, SIGTERM, SIGHUP);
    CHECK(end_of([number] {
              install_stop_handlers();
              std::raise(number);
              if (number == SIGTERM) {
                  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
              }
              std::raise(number);
              return true;
          }) == -number);
}

TEST_CASE("what a queue and the system send twice asks to stop once") {
    const int number = GENERATE(SIGTERM, SIGUSR1, SIGXCPU);
    CHECK(end_of([number] {
              install_stop_handlers();
              std::raise(number);
              std::raise(number);
              return stop_signal()->signal == number;
          }) == 0);
}

TEST_CASE("a signal that was ignored before stays so") {
    CHECK(end_of([] {
              std::signal(SIGHUP, SIG_IGN);
              install_stop_handlers();
              std::raise(SIGHUP);
              return !stop_signal().has_value();
          }) == 0);
}

TEST_CASE("what a parent has blocked is seen again, and what it ignored but for the terminal's signals") {
    const int number = GENERATE(SIGTERM, SIGUSR1, SIGXCPU);
    const bool ignored = GENERATE(false, true);
    CHECK(end_of([number, ignored] {
              sigset_t all;
              sigfillset(&all);
              sigprocmask(SIG_SETMASK, &all, nullptr);
              if (ignored) {
                  std::signal(number, SIG_IGN);
              }
              forget_inherited_signals();
              install_stop_handlers();
              std::raise(number);
              return stop_signal()->signal == number;
          }) == 0);
}

TEST_CASE("children can be waited for, though a parent ignored their ends, and a hang-up stays ignored") {
    CHECK(end_of([] {
              std::signal(SIGCHLD, SIG_IGN);
              std::signal(SIGHUP, SIG_IGN);
              forget_inherited_signals();
              install_stop_handlers();
              std::raise(SIGHUP);
              const pid_t child = ::fork();
              if (child == 0) {
                  ::_exit(7);
              }
              int status = 0;
              return ::waitpid(child, &status, 0) == child && WEXITSTATUS(status) == 7 && !stop_signal().has_value();
          }) == 0);
}
