#include "ljmd/app/child_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "ljmd/app/recorded_run.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/io/checkpoint_file.hpp"
#include "ljmd/io/input_file.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

bool is_run_of(const RecordedRun& recorded, const ChildRun& run) {
    return recorded.deck.source == run.source && recorded.deck.settings == run.settings;
}

bool has_checkpoint(const fs::path& directory) {
    const auto names = checkpoint_names();
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return fs::exists(directory / name); });
}

Job start(const ChildRun& run) {
    Job job{{"run", run.deck.string(), "--out", run.directory.string(), "--quiet", "--force", "--threads", "1"},
            run.log};
    for (const std::string& setting : run.settings) {
        job.arguments.insert(job.arguments.end(), {"--set", setting});
    }
    return job;
}

/// What a log says of how its process ended: the last line that tells of an error, else the last line.
std::string last_words(const fs::path& log) {
    constexpr std::size_t longest = 400;
    if (!why_unreadable(log).empty()) {
        return "";
    }
    std::ifstream file(log);
    std::string last;
    std::string error;
    for (std::string line; std::getline(file, line);) {
        error = line.starts_with("error: ") ? line : error;
        last = line.empty() ? last : line;
    }
    return printable(error.empty() ? last : error, longest);
}

}  // namespace

void check_log(const ChildRun& run) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(run.log, error).type();
    if (type != fs::file_type::not_found && type != fs::file_type::regular) {
        throw InputError(fmt::format("{} is in the way: a log is written there, and it is no file. Nothing was run.",
                                     run.log.string()));
    }
}

bool holds_another_run(const ChildRun& run) {
    return fs::exists(run.directory / "run.json") && !is_run_of(recorded_run(run.directory), run);
}

std::optional<Job> next_job(const ChildRun& run) {
    if (!fs::exists(run.directory / "run.json")) {
        return start(run);
    }
    const RecordedRun recorded = recorded_run(run.directory);
    if (!is_run_of(recorded, run) || (!recorded.finished && !has_checkpoint(run.directory))) {
        return start(run);
    }
    return recorded.finished ? std::nullopt
                             : std::optional(Job{{"resume", run.directory.string(), "--quiet"}, run.log});
}

Job longer(const ChildRun& run, Index more_steps) {
    return {{"resume", run.directory.string(), "--quiet", "--steps", fmt::format("+{}", more_steps)}, run.log};
}

std::string failure_of(const ChildRun& run, int exit_status) {
    return fmt::format("{}: exit code {}: {}", run.name, exit_status, last_words(run.log));
}

}  // namespace ljmd
