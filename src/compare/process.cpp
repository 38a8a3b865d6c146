#include "ljmd/compare/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/file_system.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program, glibc does not

namespace ljmd {

namespace {

namespace fs = std::filesystem;

bool is_executable(const fs::path& path) {
    return files::is_regular_file(path) && access(path.c_str(), X_OK) == 0;
}

/// Pointers to texts, with the null at the end that exec wants.
std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    result.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        result.push_back(text.data());
    }
    result.push_back(nullptr);
    return result;
}

std::vector<std::string> environment_of(const Process& process) {
    std::vector<std::string> result;
    for (const auto& [name, value] : process.environment) {
        result.push_back(fmt::format("{}={}", name, value));
    }
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        bool replaced = false;
        for (const auto& [name, value] : process.environment) {
            replaced = replaced || text.substr(0, text.find('=')) == name;
        }
        if (!replaced) {
            result.emplace_back(text);
        }
    }
    return result;
}

/// What posix_spawn does in the child before the program begins.
class Preparation {
  public:
    explicit Preparation(const Process& process) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_addchdir_np(&actions_, process.directory.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, process.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0666);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
        // This process may ignore signals by which others end.
        sigset_t usual;
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        sigaddset(&usual, SIGXFSZ);
        posix_spawnattr_setsigdefault(&attributes_, &usual);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(
            &attributes_, static_cast<short>(POSIX_SPAWN_SETSIGDEF | (process.own_group ? POSIX_SPAWN_SETPGROUP : 0)));
    }
    ~Preparation() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    Preparation(const Preparation&) = delete;
    Preparation& operator=(const Preparation&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
    [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) {
        return is_executable(name) ? std::optional(files::absolute(name)) : std::nullopt;
    }
    const char* variable = std::getenv("PATH");
    std::string_view rest = variable != nullptr ? variable : "/usr/bin:/bin";
    while (!name.empty() && !rest.empty()) {
        const std::size_t length = std::min(rest.find(':'), rest.size());
        const fs::path candidate = fs::path(rest.substr(0, length)) / name;  // an empty one is where we are
        if (is_executable(candidate)) {
            return files::absolute(candidate);
        }
        rest.remove_prefix(std::min(length + 1, rest.size()));
    }
    return std::nullopt;
}

ChildProcess::ChildProcess(const Process& process) : name_(process.program.string()) {
    std::vector<std::string> arguments{name_};
    arguments.insert(arguments.end(), process.arguments.begin(), process.arguments.end());
    std::vector<std::string> environment = environment_of(process);
    const Preparation preparation(process);
    const int error = posix_spawn(&id_, process.program.c_str(), preparation.actions(), preparation.attributes(),
                                  pointers(arguments).data(), pointers(environment).data());
    if (error != 0) {
        throw FileError(fmt::format("cannot start '{}' in '{}' with its output in '{}': {}", name_,
                                    process.directory.string(), process.output.string(), std::strerror(error)));
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
            throw FileError(fmt::format("lost sight of '{}' while it ran: {}", name_, std::strerror(errno)));
        }
    }
    return status_;
}

void ChildProcess::signal(int number) const {
    if (!status_) {
        kill(id_, number);
    }
}

int run_process(const Process& process) {
    return ChildProcess(process).wait();
}

}  // namespace ljmd
