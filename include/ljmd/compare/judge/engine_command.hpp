#pragma once

#include <filesystem>
#include <string>

#include "ljmd/run/interruption.hpp"

namespace ljmd {

/// The command line of an engine: a template with {input} and {output} in the place of two directories.
///
///     ./engine {input} {output}      ->      ./engine 'exchange/problem' 'exchange/answer'
///
/// It is a command of the shell, /bin/sh -c, in which everything but the two names means what it means there. The names
/// are quoted: whatever characters they have, they are one word each.
/// @throws InputError  a name is missing, or stands within quotes or beside one, where it would be quoted twice
[[nodiscard]] std::string engine_command(const std::string& command, const std::filesystem::path& input,
                                         const std::filesystem::path& output);

/// Run it in the working directory, with an empty stdin; what it prints goes to the file `log`. It is stopped, with all
/// processes that it has started, when the time is over, when it prints more than 64 MiB, and when ljmd is asked to
/// stop.
/// @param seconds  wall time
/// @throws DataError  it ends with another exit status than 0, takes longer or prints more; with its last lines
/// @throws Interrupted
void run_engine(const std::string& command, const std::filesystem::path& log, double seconds,
                const Interruption& interruption);

}  // namespace ljmd
