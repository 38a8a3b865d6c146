#include "ljmd/app/streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "ljmd/core/errors.hpp"

namespace ljmd {

void prepare_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) == -1) {
            // The lowest free number is this one. For stdout the wrong way round: results must not vanish without a
            // word.
            [[maybe_unused]] const int opened = ::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
    // A closed pipe or a file-size limit then shows as a failed write, which is reported, instead of a silent end.
    static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
    static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
}

void print_result(const std::string& text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
        return;
    }
    const int error = errno;
    if (error == EPIPE) {
        static_cast<void>(std::signal(SIGPIPE, SIG_DFL));
        static_cast<void>(std::raise(SIGPIPE));
    }
    throw FileError(
        fmt::format("standard output: the results could not be written: {}", std::generic_category().message(error)));
}

void talk(const std::string& text) noexcept {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    static_cast<void>(std::fflush(stderr));
}

void talk_of_warnings(const Diagnostics& diagnostics) {
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.severity == Severity::warning) {
            talk(format(entry) + '\n');
        }
    }
}

}  // namespace ljmd
