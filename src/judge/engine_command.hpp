#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "ljmd/detail/run/interruption.hpp"

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

/// What an engine may take.
struct EngineLimits {
    double seconds;                                     ///< wall time
    std::filesystem::path folder = {};                  ///< that it writes to; empty: it writes nothing
    std::uintmax_t written = std::uintmax_t{4} << 30U;  ///< bytes of the files there
};

/// Run it in the working directory, with an empty stdin; what it prints goes to the file `log`. It is stopped, with all
/// processes that it has started, when it goes beyond a limit, when it prints more than 64 MiB, and when ljmd is asked
/// to stop.
/// @throws DataError  it ends with another exit status than 0, or went beyond a limit; with its last lines
/// @throws Interrupted
void run_engine(const std::string& command, const std::filesystem::path& log, const EngineLimits& limits,
                const Interruption& interruption);

}  // namespace ljmd
