#pragma once

#include <optional>
#include <string>

#include "ljmd/detail/run/interruption.hpp"

namespace ljmd {

/// Reset signal settings inherited from the parent: blocked signals, and ignored SIGCHLD, SIGTERM, SIGUSR1 and SIGXCPU.
/// With SIGCHLD ignored, waiting for children would fail. SIGINT and SIGHUP stay ignored, because nohup and shells use
/// this to protect a program from the terminal's keys and its end. @pre no threads yet
void forget_inherited_signals();

/// From now on SIGINT, SIGHUP, SIGTERM, SIGUSR1 and SIGXCPU ask the program to stop, unless they are ignored. A second
/// SIGINT, SIGHUP or SIGTERM ends it at once, a SIGTERM only if it comes more than a second after the first: queues
/// send it twice. The other two do not, because queues and the system repeat them.
void install_stop_handlers();

/// Ignore the signals that ask the program to stop: for a rank that follows rank 0, which decides for all.
void ignore_stop_signals();

/// The signal that asked to stop, if any.
[[nodiscard]] std::optional<StopRequest> stop_signal();

/// What --walltime gives: "90 s", "30 min", "2h" or "1 d" in seconds; nothing for an empty text. @throws InputError
[[nodiscard]] std::optional<double> wall_time(const std::string& text);

/// An Interruption by such a signal or by wall time. @param walltime  [s] from now; none: no limit
[[nodiscard]] Interruption until_signal(std::optional<double> walltime = std::nullopt);

}  // namespace ljmd
