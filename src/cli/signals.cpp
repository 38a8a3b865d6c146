#include "cli/signals.hpp"

#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX's

#include <array>
#include <atomic>
#include <cstdint>
#include <ctime>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/units.hpp"

namespace ljmd {

namespace {

volatile sig_atomic_t received = 0;

extern "C" void receive(int signal) {
    received = signal;
}

/// When the first SIGTERM came [ns of the system's clock]; 0: none has.
std::atomic<std::int64_t> terminated_at{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);  // so it may be used where a signal is handled

/// Slurm sends SIGTERM to a task twice within milliseconds, when the task is cancelled and at its time limit. A second
/// one that comes within a second is this repetition; a later one ends the program.
extern "C" void receive_termination(int signal) {
    constexpr std::int64_t second = 1'000'000'000;
    timespec clock{};
    ::clock_gettime(CLOCK_MONOTONIC, &clock);
    const std::int64_t now = clock.tv_sec * second + clock.tv_nsec + 1;
    std::int64_t first = 0;
    if (!terminated_at.compare_exchange_strong(first, now) && now - first >= second) {
        static_cast<void>(::signal(signal, SIG_DFL));
        static_cast<void>(::raise(signal));
    }
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
        const bool may_come_twice = one.number == SIGTERM;
        wanted.sa_handler = may_come_twice ? receive_termination : receive;
        wanted.sa_flags = static_cast<int>(SA_RESTART | (one.once && !may_come_twice ? SA_RESETHAND : 0U));
        ::sigaction(one.number, &wanted, nullptr);
    }
}

void ignore_stop_signals() {
    for (const StopSignal& one : stop_signals) {
        static_cast<void>(::signal(one.number, SIG_IGN));
    }
}

std::optional<StopRequest> stop_signal() {
    const int number = received;
    return number == 0 ? std::nullopt : std::optional(StopRequest{number, name_of(number)});
}

std::optional<double> wall_time(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const auto seconds = parse_wall_time(text);
    if (!seconds) {
        throw InputError(fmt::format(
            "--walltime: '{}' is no wall time; allowed: a number > 0 with s, min, h or d, as in 90s or 2h", text));
    }
    return seconds;
}

Interruption until_signal(std::optional<double> walltime) {
    return Interruption(walltime, stop_signal);
}

}  // namespace ljmd
