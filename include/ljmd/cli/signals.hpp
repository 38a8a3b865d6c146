#pragma once

#include <optional>

#include "ljmd/run/interruption.hpp"

namespace ljmd {

/// Undo what a parent may have left to this program: a mask that keeps signals from it for ever, and SIGCHLD, SIGTERM,
/// SIGUSR1 and SIGXCPU ignored. Without SIGCHLD no child could be waited for. SIGINT and SIGHUP stay ignored where they
/// are: so nohup and shells keep a terminal's keys and its end from a program. @pre no threads yet
void forget_inherited_signals();

/// From now on SIGINT, SIGHUP, SIGTERM, SIGUSR1 and SIGXCPU ask the program to stop, where they are not ignored. The
/// second SIGINT, SIGHUP or SIGTERM ends it at once; the other two, which queues and the system repeat, do not.
void heed_signals();

/// The signal that has asked to stop, if there was one.
[[nodiscard]] std::optional<StopRequest> stop_signal();

/// What goes on until such a signal comes, or its time is over. @param walltime  [s] from now; none: no limit
[[nodiscard]] Interruption until_signal(std::optional<double> walltime = std::nullopt);

}  // namespace ljmd
