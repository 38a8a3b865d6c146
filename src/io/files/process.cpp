#include "io/files/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX's
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <thread>
#include <utility>

#include "execution/signals_blocked.hpp"
#include "io/files/file_calls.hpp"
#include "io/files/file_system.hpp"
#include "io/files/pipe.hpp"

#if defined(__linux__)
#include <sys/prctl.h>
#endif

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program, glibc does not

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Directories of PATH that cannot be looked into are passed over, as shells do. @throws FileError
bool is_executable(const fs::path& path) {
    if (access(path.c_str(), X_OK) != 0) {
        if (errno == EIO) {
            throw file_error("look at", path, errno);
        }
        return false;
    }
    return files::is_regular_file(path);
}

/// Pointers to the texts, with the null pointer that exec expects at the end.
std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    result.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        result.push_back(text.data());
    }
    result.push_back(nullptr);
    return result;
}

using Variables = std::vector<std::pair<std::string, std::string>>;

/// Whether a variable tells a process that it is one of those that mpirun has started. A child is not: with it, a
/// program that knows MPI would wait for ranks that there are not.
bool is_of_ranks(std::string_view variable) {
    return variable.starts_with("OMPI_") || variable.starts_with("PMI_") || variable.starts_with("PMIX_");
}

/// The environment of this process with variables added or replaced, without mpirun's.
/// @param without  as in Process
std::vector<std::string> environment_with(const Variables& added, const std::vector<std::string>& without = {}) {
    std::vector<std::string> result;
    for (const auto& [name, value] : added) {
        result.push_back(fmt::format("{}={}", name, value));
    }
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        bool replaced = is_of_ranks(text) || std::ranges::any_of(without, [&](const std::string& beginning) {
                            return text.starts_with(beginning);
                        });
        for (const auto& [name, value] : added) {
            replaced = replaced || text.substr(0, text.find('=')) == name;
        }
        if (!replaced) {
            result.emplace_back(text);
        }
    }
    return result;
}

/// Reset all signals to their default actions and unblock them. Signals that the parent was told to ignore stay
/// ignored; SIGPIPE and SIGXFSZ do not, because this program itself ignores them.
void default_signals() {
    for (int number = 1; number < NSIG; ++number) {
        struct sigaction action {};
        if (::sigaction(number, nullptr, &action) == 0 &&
            (action.sa_handler != SIG_IGN || number == SIGPIPE || number == SIGXFSZ)) {
            action = {};
            action.sa_handler = SIG_DFL;
            ::sigaction(number, &action, nullptr);
        }
    }
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

#if defined(__linux__)

void end_with_parent(int number) {
    ::prctl(PR_SET_PDEATHSIG, number);
}

void adopt_orphans() {
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
}

#else  // has neither

void end_with_parent(int /*number*/) {}

void adopt_orphans() {}

#endif

/// Receive a signal when the thread that started this process ends. @return whether the parent is still alive
bool tied_to_parent(int number, pid_t parent) {
    end_with_parent(number);
    return ::getppid() == parent;
}

/// Become the program, in the child process. No memory is allocated and no lock is taken: another thread of the parent
/// may have held one at the fork. @return only on failure, with errno set
void become(const Process& process, char* const* arguments, char* const* environment, pid_t parent) {
    if (process.at_our_end != 0 && !tied_to_parent(process.at_our_end, parent)) {
        ::_exit(EXIT_FAILURE);
    }
    if (process.own_group || process.kept) {
        ::setpgid(0, 0);
    }
    if (::chdir(process.directory.c_str()) != 0) {
        return;
    }
    const int input = process.input >= 0 ? process.input : ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const int output =
        process.output_descriptor >= 0
            ? process.output_descriptor
            : ::open(process.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
    const int errors = process.errors.empty() ? output
                                              : ::open(process.errors.c_str(),
                                                       O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (input < 0 || output < 0 || errors < 0 || ::dup2(input, STDIN_FILENO) < 0 || ::dup2(output, STDOUT_FILENO) < 0 ||
        ::dup2(errors, STDERR_FILENO) < 0) {
        return;
    }
    default_signals();
    ::execve(process.program.c_str(), arguments, environment);
}

/// Kill the children of this process that the kernel lists. @return whether there was one that can be killed
bool kill_children() {
    std::array<char, 4096> text{};
    const int list = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
    const ssize_t length = ::read(list, text.data(), text.size());
    ::close(list);
    bool found = false;
    pid_t id = 0;
    for (ssize_t k = 0; k < length; ++k) {
        const char c = text[static_cast<std::size_t>(k)];
        if (c >= '0' && c <= '9') {
            id = 10 * id + (c - '0');
        } else if (id > 0) {  // a number that ends behind the text is one of the next time
            found = ::kill(std::exchange(id, 0), SIGKILL) == 0 || found;
        }
    }
    return found;
}

/// Kill all descendants of this process: children of those that have ended become its own.
void end_descendants() {
    constexpr int many = 100;  // a process that comes and goes may be missing in the list; others cannot be killed
    constexpr int moment = 1;  // [ms]
    for (int looks = 0; looks < many; ++looks) {
        looks = kill_children() ? 0 : looks;
        pid_t ended = 0;
        do {
            ended = ::waitpid(-1, nullptr, WNOHANG);
        } while (ended > 0);
        if (ended < 0) {
            return;
        }
        ::poll(nullptr, 0, moment);
    }
}

/// Be the keeper of a program, in the child process; as careful as become().
/// @param lifeline  readable, or at its end, when all is to end
/// @param failure   receives the error number if the program cannot be started
[[noreturn]] void keep(const Process& process, char* const* arguments, char* const* environment, int lifeline,
                       int failure) {
    adopt_orphans();
    ::setpgid(0, 0);
    struct sigaction noted {};
    noted.sa_handler = [](int) {};  // the call that waits returns
    ::sigaction(SIGCHLD, &noted, nullptr);
    const pid_t keeper = ::getpid();
    const pid_t program = ::fork();
    if (program <= 0) {
        if (program == 0) {
            become(process, arguments, environment, keeper);
        }
        [[maybe_unused]] const auto told = ::write(failure, &errno, sizeof errno);
        ::_exit(EXIT_FAILURE);
    }
    ::close(failure);
    sigset_t all_but_ends;
    sigfillset(&all_but_ends);
    sigdelset(&all_but_ends, SIGCHLD);
    std::optional<int> status;
    do {
        int found = 0;
        pid_t ended = 0;
        while ((ended = ::waitpid(-1, &found, WNOHANG)) > 0) {
            if (ended == program) {
                status = found;
            }
        }
        pollfd end{.fd = lifeline, .events = POLLIN, .revents = 0};
        if (!status && ::ppoll(&end, 1, nullptr, &all_but_ends) > 0) {
            status = SIGKILL;
        }
    } while (!status);
    end_descendants();
    ::_exit(WIFSIGNALED(*status) ? 128 + WTERMSIG(*status) : WEXITSTATUS(*status));
}

std::vector<std::string> command_line(const std::string& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> result{program};
    result.insert(result.end(), arguments.begin(), arguments.end());
    return result;
}

/// The result of fork() and become().
struct Launched {
    pid_t id;
    int error;  ///< 0: the program runs
};

/// @param lifeline  of the keeper; null: there is none
/// @throws ProcessesError
Launched launch(const Process& process, const std::vector<char*>& arguments, const std::vector<char*>& environment,
                Pipe* lifeline) {
    Pipe failure;  // closed by exec, or receives the error number
    const pid_t parent = ::getpid();
    Launched launched{};
    {
        const SignalsBlocked until_its_own_are_set;  // in the child, our handlers would swallow signals
        launched.id = ::fork();
        launched.error = launched.id < 0 ? errno : 0;
        if (launched.id == 0 && lifeline != nullptr) {
            lifeline->close_write_end();
            keep(process, arguments.data(), environment.data(), lifeline->read_end(), failure.write_end());
        }
        if (launched.id == 0) {
            become(process, arguments.data(), environment.data(), parent);
            [[maybe_unused]] const auto told = ::write(failure.write_end(), &errno, sizeof errno);
            ::_exit(EXIT_FAILURE);
        }
    }
    if (launched.id < 0) {
        throw ProcessesError(fmt::format("cannot start '{}': the system has no room for another process: {}",
                                         process.program.string(), std::strerror(launched.error)));
    }
    failure.close_write_end();
    while (::read(failure.read_end(), &launched.error, sizeof launched.error) < 0 && errno == EINTR) {
    }
    return launched;
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) {
        return is_executable(name) ? std::optional(files::absolute(name)) : std::nullopt;
    }
    const char* variable = std::getenv("PATH");
    std::string_view rest = variable != nullptr ? variable : "/usr/bin:/bin";
    while (!name.empty() && !rest.empty()) {
        const std::size_t length = std::min(rest.find(':'), rest.size());
        const fs::path candidate = fs::path(rest.substr(0, length)) / name;  // empty: the working directory
        if (is_executable(candidate)) {
            return files::absolute(candidate);
        }
        rest.remove_prefix(std::min(length + 1, rest.size()));
    }
    return std::nullopt;
}

ChildProcess::ChildProcess(const Process& process)
    : name_(process.program.string()), lifeline_(process.kept ? std::make_unique<Pipe>() : nullptr) {
    std::vector<std::string> arguments = command_line(name_, process.arguments);
    std::vector<std::string> environment = environment_with(process.environment, process.without);
    const Launched launched = launch(process, pointers(arguments), pointers(environment), lifeline_.get());
    id_ = launched.id;
    if (launched.error != 0) {
        static_cast<void>(wait());
        throw FileError(fmt::format("cannot start '{}' in '{}' with its output in '{}': {}", name_,
                                    process.directory.string(), process.output.string(),
                                    std::strerror(launched.error)));
    }
}

std::optional<int> ChildProcess::wait(bool block) {
    int status = 0;
    while (!status_) {
        const pid_t found = waitpid(id_, &status, block ? 0 : WNOHANG);
        if (found == 0) {
            return std::nullopt;
        }
        if (found == id_) {
            status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        } else if (errno != EINTR) {
            throw FileError(fmt::format("cannot wait for the end of '{}': {}", name_, std::strerror(errno)));
        }
    }
    return status_;
}

std::optional<int> ChildProcess::wait_while(const std::function<bool()>& go_on) {
    constexpr std::chrono::milliseconds look_again{10};
    while (!ended() && go_on()) {
        std::this_thread::sleep_for(look_again);
    }
    return status_;
}

void ChildProcess::signal(int number) const {
    if (!status_) {
        kill(id_, number);
    }
}

void ChildProcess::stop() {
    [[maybe_unused]] const auto told = ::write(lifeline_->write_end(), "", 1);
    static_cast<void>(wait());
}

int run_process(const Process& process) {
    return ChildProcess(process).wait();
}

void become_program(const fs::path& program, const std::vector<std::string>& arguments, const Variables& environment) {
    std::vector<std::string> words = command_line(program.string(), arguments);
    std::vector<std::string> variables = environment_with(environment);
    default_signals();
    ::execve(program.c_str(), pointers(words).data(), pointers(variables).data());
    throw file_error("start", program, errno);
}

}  // namespace ljmd
