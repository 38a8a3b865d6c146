#include "cli/streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "core/terminal_text.hpp"
#include "core/text.hpp"
#include "io/files/shell_word.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

void prepare_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) == -1) {
            // The lowest free number is this one. stdout is opened for reading only, so that writing results fails and
            // is reported.
            [[maybe_unused]] const int opened = ::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
    // A closed pipe or a file-size limit then causes a failed write, which is reported, and not a silent end.
    static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
    static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
}

namespace {

constexpr std::size_t usual_columns = 80;

std::size_t width_of_terminal(int descriptor) {
    winsize size{};
    const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : usual_columns;
}

/// Number of bytes at the beginning of a text that may be written to a terminal unchanged.
std::size_t harmless_beginning(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size()) {
        const bool is_layout = text[end] == '\n' || text[end] == '\t';
        const std::size_t length = is_layout ? 1 : harmless_length(text.substr(end));
        if (length == 0) {
            break;
        }
        end += length;
    }
    return end;
}

/// The only way to a terminal for text from others: names of files, titles, output of other programs. Allocates no
/// memory, because the message may be that there is none. @return false when the text cannot be written
bool write_harmless(std::string_view text, std::FILE* stream) noexcept {
    while (!text.empty()) {
        const std::size_t harmless = harmless_beginning(text);
        if (std::fwrite(text.data(), 1, harmless, stream) != harmless) {
            return false;
        }
        text.remove_prefix(harmless);
        if (!text.empty()) {
            if (std::fputc('?', stream) == EOF) {
                return false;
            }
            text.remove_prefix(std::max<std::size_t>(utf8_length(text), 1));
        }
    }
    return true;
}

}  // namespace

void print_result(const std::string& text) {
    errno = 0;
    if (write_harmless(text, stdout) && std::fflush(stdout) == 0) {
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

void print_document(const Document& document, bool as_json) {
    print_result(as_json ? to_json(document.data) + "\n" : document.text);
}

void print_message(const std::string& text) noexcept {
    static_cast<void>(write_harmless(text, stderr));
    static_cast<void>(std::fflush(stderr));
}

void warn(const std::string& text) noexcept {
    print_message("warning: " + text + "\n");
}

std::optional<std::size_t> message_columns() {
    const char* kind = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nobody writes the environment
    if (::isatty(STDERR_FILENO) != 1 || (kind != nullptr && std::string_view(kind) == "dumb")) {
        return std::nullopt;
    }
    return width_of_terminal(STDERR_FILENO);
}

std::optional<std::size_t> result_columns() {
    return ::isatty(STDOUT_FILENO) == 1 ? std::optional(width_of_terminal(STDOUT_FILENO)) : std::nullopt;
}

bool messages_stand_beside_results() {
    struct stat messages {};
    struct stat results {};
    return ::isatty(STDERR_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1 && ::fstat(STDERR_FILENO, &messages) == 0 &&
           ::fstat(STDOUT_FILENO, &results) == 0 && messages.st_rdev == results.st_rdev;
}

void talk_over_line(const std::string& text) {
    // Written at once, because stderr has no buffer, and erased last: so the line does not flicker. What is erased is
    // all to the end of the screen: the rest of a longer line that a narrower terminal has wrapped. While the line is
    // written the terminal does not wrap: it may have become narrower since it was asked for its width.
    std::string line = "\r\033[?7l";
    for (const std::string& character : printable_characters(text)) {
        line += character;
    }
    line += "\033[J\033[?7h\r";
    static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
    static_cast<void>(std::fflush(stderr));
}

std::string told_files(const std::filesystem::path& directory) {
    return fmt::format("\nfiles: {}\nto draw them: ljmd plot {}\n", directory.string(), shell_word(directory));
}

void print_warnings(const Diagnostics& diagnostics) {
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.severity == Severity::warning) {
            print_message(format(entry) + '\n');
        }
    }
}

}  // namespace ljmd
