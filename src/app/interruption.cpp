#include "ljmd/app/interruption.hpp"

#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX's

#include <array>

namespace ljmd {

namespace {

constexpr int walltime_reached = 75;  // EX_TEMPFAIL: try again later

volatile sig_atomic_t received = 0;

extern "C" void receive(int signal) {
    received = signal;
}

/// A signal that asks the program to stop.
struct StopSignal {
    int number;
    const char* name;
    bool may_be_ignored;  ///< where the parent ignores it: nohup, or a shell's background
    bool once;            ///< the second one ends the program
};

/// SIGUSR1 is a queue's warning that time is short. SIGXCPU comes every second once the processor time is used up.
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

void heed_signals() {
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

int signal_received() {
    return received;
}

int signal_exit_code(int signal) {
    constexpr int base = 128;
    return base + signal;
}

void stop_many_runs() {
    throw Interrupted("stopped; to go on, give the same command again", signal_exit_code(signal_received()));
}

Interruption::Interruption(std::optional<double> walltime) {
    if (walltime) {
        end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*walltime));
    }
}

void Interruption::stop(Index step, const std::string& directory) const {
    const int signal = signal_received();
    throw Interrupted(fmt::format("stopped after step {} by {}; to go on: ljmd resume {}", step,
                                  signal != 0 ? name_of(signal) : std::string("the end of its wall time"), directory),
                      signal != 0 ? signal_exit_code(signal) : walltime_reached);
}

}  // namespace ljmd
