#include "study/child_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string_view>
#include <thread>

#include "core/text.hpp"
#include "io/files/checkpoint_file.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "ljmd/core/errors.hpp"
#include "run/recorded_run.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

bool is_run_of(const RecordedRun& recorded, const ChildRun& run) {
    return recorded.deck.source == run.source && recorded.deck.settings == run.settings;
}

enum class Held { nothing, this_run, another, unreadable };

Held held_in(const ChildRun& run) {
    if (!files::exists(run.directory / "run.json")) {
        return Held::nothing;
    }
    try {
        return is_run_of(recorded_run(run.directory), run) ? Held::this_run : Held::another;
    } catch (const DataError&) {
        return Held::unreadable;
    }
}

bool has_checkpoint(const fs::path& directory) {
    const auto names = checkpoint_names();
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return files::exists(directory / name); });
}

Job start(const ChildRun& run) {
    if (read_input(run.deck) != run.source) {
        throw DataError(fmt::format("{} is not the deck that was prepared; the command that prepared it puts it back",
                                    run.deck.string()));
    }
    Job job{{"run", run.deck.string(), "--out", run.directory.string(), "--quiet", "--force", "--threads", "1"},
            run.log};
    for (const std::string& setting : run.settings) {
        job.arguments.insert(job.arguments.end(), {"--set", setting});
    }
    return job;
}

constexpr std::string_view end_line = "ended with exit code ";

struct LastLines {
    std::string error;  ///< the last line with an error
    std::string any;
    std::string exit_code;  ///< empty if none was noted
};

LastLines last_lines(const fs::path& log) {
    LastLines last;
    try {
        std::ifstream file = open_input(log);
        for (std::string line; std::getline(file, line);) {
            if (line.starts_with(end_line)) {
                last.exit_code = line.substr(end_line.size());
                continue;
            }
            last.error = line.starts_with("error: ") ? line : last.error;
            last.any = line.empty() ? last.any : line;
        }
    } catch (const DataError& error) {
        last.any = error.what();
    }
    return last;
}

constexpr std::size_t longest_log_words = 400;  // of a log, in a message
constexpr int walltime_reached = 75;

std::string words_of(const LastLines& last) {
    return printable(last.error.empty() ? last.any : last.error, longest_log_words);
}

/// "exit code 5: error: blown up", "exit code 137 (signal 9)".
std::string end_in_words(const std::string& exit_code, const LastLines& last) {
    constexpr int first_of_signals = 129;
    constexpr int last_of_signals = 192;
    const std::string words = words_of(last);
    int code = 0;
    std::from_chars(exit_code.data(), exit_code.data() + exit_code.size(), code);
    const bool killed = code >= first_of_signals && code <= last_of_signals;
    return fmt::format("exit code {}{}{}", printable(exit_code, longest_log_words),
                       killed ? fmt::format(" (signal {})", code - (first_of_signals - 1)) : "",
                       words.empty() ? "" : ": " + words);
}

}  // namespace

void check_places(const ChildRun& run) {
    for (const fs::path& path : {run.directory.parent_path(), run.directory}) {
        if (files::type_of(path) == fs::file_type::symlink) {
            throw InputError(fmt::format("{} is in the way: a run is made there, and it is a link. Nothing was run.",
                                         path.string()));
        }
    }
    const fs::file_type log = files::type_of(run.log);
    if (log != fs::file_type::not_found && log != fs::file_type::regular) {
        throw InputError(fmt::format("{} is in the way: a log is written there, and it is no file. Nothing was run.",
                                     run.log.string()));
    }
}

void wait_for_runs(const fs::path& folder, const Interruption& interruption,
                   const std::function<void(const std::string&)>& tell) {
    constexpr std::chrono::milliseconds moment{50};
    if (!files::exists(folder)) {
        return;
    }
    for (const fs::path& entry : files::list(folder)) {
        for (bool told = false; DirectoryLock::is_held(entry); told = true) {
            if (interruption.request()) {
                interruption.stop_many_runs();
            }
            if (!told) {
                tell(fmt::format("waiting for the run that is still writing to {}\n", entry.string()));
            }
            std::this_thread::sleep_for(moment);
        }
    }
}

bool holds_another_run(const ChildRun& run) {
    return held_in(run) == Held::another;
}

std::optional<Job> next_job(const ChildRun& run) {
    if (!files::exists(run.directory / "run.json")) {
        return start(run);
    }
    const RecordedRun recorded = recorded_run(run.directory);
    if (!is_run_of(recorded, run)) {
        throw DataError(fmt::format("{} holds a run of another deck or with other settings. It was left as it is",
                                    run.directory.string()));
    }
    if (!recorded.finished && !has_checkpoint(run.directory)) {
        return start(run);
    }
    return recorded.finished ? std::nullopt
                             : std::optional(Job{{"resume", run.directory.string(), "--quiet"}, run.log});
}

void forget_another_run(const ChildRun& run) {
    const Held held = held_in(run);
    if (!DirectoryLock::is_held(run.directory) && (held == Held::another || held == Held::unreadable)) {
        files::remove(run.directory / "run.json");
    }
}

Job longer(const ChildRun& run, Index more_steps) {
    return {{"resume", run.directory.string(), "--quiet", "--steps", fmt::format("+{}", more_steps)}, run.log};
}

std::string failure_of(const ChildRun& run, int exit_status) {
    return fmt::format("{}: {}", run.name, end_in_words(fmt::format("{}", exit_status), last_lines(run.log)));
}

void record_end(const ClaimedFile& log, int exit_status) {
    constexpr std::array stopped{walltime_reached, 128 + SIGHUP,  128 + SIGINT,
                                 128 + SIGUSR1,    128 + SIGTERM, 128 + SIGXCPU};
    if (exit_status != 0 && std::ranges::find(stopped, exit_status) == stopped.end()) {
        try {
            log.append(fmt::format("{}{}\n", end_line, exit_status));
        } catch (const FileError&) {  // no space: the words of the run, if there was room for them, tell of the failure
        }
    }
}

std::string recorded_failure(const fs::path& log) {
    const LastLines last = last_lines(log);
    return last.exit_code.empty() ? printable(last.error, longest_log_words) : end_in_words(last.exit_code, last);
}

}  // namespace ljmd
