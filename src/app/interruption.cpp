#include "ljmd/app/interruption.hpp"

#include <fmt/format.h>

#include <csignal>

namespace ljmd {

namespace {

constexpr int walltime_reached = 75;  // EX_TEMPFAIL: try again later

volatile std::sig_atomic_t received = 0;

extern "C" void receive(int signal) {
    received = signal;
}

const char* name_of(int signal) {
    switch (signal) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        default:
            return "SIGHUP";
    }
}

}  // namespace

void heed_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        sigaction(signal, nullptr, &now);
        if (now.sa_handler == SIG_IGN) {  // nohup, or a shell's background
            continue;
        }
        struct sigaction wanted {};
        wanted.sa_handler = receive;
        wanted.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        sigaction(signal, &wanted, nullptr);
    }
}

int signal_received() {
    return received;
}

int signal_exit_code(int signal) {
    constexpr int base = 128;
    return base + signal;
}

Interruption::Interruption(std::optional<double> walltime) {
    if (walltime) {
        end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*walltime));
    }
}

void Interruption::stop(Index step, const std::string& directory) const {
    const int signal = signal_received();
    throw Interrupted(fmt::format("stopped after step {} by {}; to go on: ljmd resume {}", step,
                                  signal != 0 ? name_of(signal) : "the end of its wall time", directory),
                      signal != 0 ? signal_exit_code(signal) : walltime_reached);
}

}  // namespace ljmd
