#include "ljmd/cli/signals.hpp"

#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX's

#include <array>

namespace ljmd {

namespace {

volatile sig_atomic_t received = 0;

extern "C" void receive(int signal) {
    received = signal;
}

/// A signal that asks the program to stop.
struct StopSignal {
    int number;
    const char* name;
    bool may_be_ignored;  ///< if the parent ignores it: nohup, or a background job of a shell
    bool once;            ///< a second one ends the program
};

/// SIGUSR1 is a queue's warning before its time limit. SIGXCPU comes every second once the processor time is used up.
constexpr std::array<StopSignal, 5> stop_signals{{{SIGINT, "SIGINT", true, true},
                                                  {SIGHUP, "SIGHUP", true, true},
                                                  {SIGTERM, "SIGTERM", false, true},
                                                  {SIGUSR1, "SIGUSR1", false, false},
                                                  {SIGXCPU, "SIGXCPU", false, false}}};

std::string name_of(int signal) {
    for (const StopSignal& one : stop_signals) {
        if (one.number == signal) {
            return one.name;
        }
    }
    throw ContractViolation(fmt::format("signal {} does not ask to stop", signal));
}

}  // namespace

void forget_inherited_signals() {
    static_cast<void>(::signal(SIGCHLD, SIG_DFL));
    for (const StopSignal& one : stop_signals) {
        if (!one.may_be_ignored) {
            static_cast<void>(::signal(one.number, SIG_DFL));
        }
    }
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void install_stop_handlers() {
    for (const StopSignal& one : stop_signals) {
        struct sigaction now {};
        ::sigaction(one.number, nullptr, &now);
        if (now.sa_handler == SIG_IGN) {
            continue;
        }
        struct sigaction wanted {};
        wanted.sa_handler = receive;
        wanted.sa_flags = static_cast<int>(SA_RESTART | (one.once ? SA_RESETHAND : 0U));
        ::sigaction(one.number, &wanted, nullptr);
    }
}

std::optional<StopRequest> stop_signal() {
    const int number = received;
    return number == 0 ? std::nullopt : std::optional(StopRequest{number, name_of(number)});
}

Interruption until_signal(std::optional<double> walltime) {
    return Interruption(walltime, stop_signal);
}

}  // namespace ljmd
