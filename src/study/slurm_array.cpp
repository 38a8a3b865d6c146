#include "ljmd/study/slurm_array.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/files/open_directory.hpp"
#include "ljmd/io/files/process.hpp"
#include "ljmd/io/files/scratch_directory.hpp"
#include "ljmd/io/files/shell_word.hpp"
#include "ljmd/run/output_guard.hpp"
#include "ljmd/study/job_pool.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr const char* folder_name = "slurm";  // in the directory of the study: the script, and what workers say
constexpr const char* script_name = "worker.sh";
constexpr const char* script_mark = "# A task of an array: the worker of that number.\n";

/// Seconds before its time limit at which a task is told to stop. Slurm rounds them: the signal may come a minute
/// earlier.
constexpr int seconds_of_warning = 120;

fs::path program_of_slurm(const std::string& name) {
    if (const auto found = find_program(name)) {
        return *found;
    }
    throw InputError(
        fmt::format("--slurm: there is no {} on this computer. Nothing was run.\n  give the command where jobs are "
                    "submitted, or prepare the directory with --prepare and start workers with --work K/T",
                    name));
}

struct Answer {
    int status;
    std::string text;  ///< all that it printed
};

/// Run a program that ends at once. squeue takes filters and formats also from variables, SQUEUE_PARTITION for one,
/// which would hide an array: it gets none of them.
Answer answer_of(const fs::path& program, std::vector<std::string> arguments) {
    const ScratchDirectory scratch;
    const fs::path output = scratch.path() / "output";
    const int status = run_process({.program = program,
                                    .arguments = std::move(arguments),
                                    .directory = ".",
                                    .output = output,
                                    .without = "SQUEUE_"});
    return {status, read_input(output)};
}

/// What a program of Slurm said, for a message: its first lines.
std::string said(const std::string& text) {
    constexpr std::size_t longest = 300;
    constexpr std::size_t most = 6;
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string line; words.size() < most && std::getline(lines, line);) {
        words.push_back(printable(trimmed(line), longest));
    }
    return fmt::format("{}", fmt::join(words, "\n  "));
}

/// A path in which sbatch replaces nothing.
std::string literal_pattern(const fs::path& path) {
    std::string pattern;
    for (const char c : path.string()) {
        pattern += c == '%' ? std::string("%%") : std::string(1, c);
    }
    return pattern;
}

/// "argon-sweep-0123456789abcdef": differs for any two directories.
std::string array_name(const fs::path& directory) {
    std::string name = directory.filename().string();
    std::ranges::replace_if(
        name, [](unsigned char c) { return c >= 128 || (std::isalnum(c) == 0 && c != '-' && c != '_' && c != '.'); },
        '_');
    const std::string path = directory.string();
    return fmt::format("{}-{:016x}", name, XXH3_64bits(path.data(), path.size()));
}

/// The number of a job in what `sbatch --parsable` prints, "17" or "17;cluster".
std::optional<std::string> job_number(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string number = line.substr(0, line.find(';'));
        if (!number.empty() && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; })) {
            return number;
        }
    }
    return std::nullopt;
}

/// Whether a word is an option in one of its forms: "-a1-3", "--array=1-3", shortened as sbatch takes it, "--arr", or
/// behind letters that need no value, "-Ha1-3".
/// @param least  of `name`, by which sbatch knows the option
bool is_option(const std::string& word, char letter, const std::string& least, const std::string& name) {
    const std::string given = word.substr(0, word.find('='));
    if (given.starts_with(least) && name.starts_with(given)) {
        return true;
    }
    if (!word.starts_with('-')) {
        return false;
    }
    const std::size_t first = word.find_first_not_of("HhIkOQsvVW", 1);
    return first != std::string::npos && word[first] == letter;
}

}  // namespace

std::vector<std::string> shell_words(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    bool in_word = false;
    char quote = '\0';
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\\' && quote != '\'' && i + 1 < text.size()) {
            word += text[++i];
            in_word = true;
        } else if (quote != '\0' ? c == quote : c == '\'' || c == '"') {
            quote = quote == '\0' ? c : '\0';
            in_word = true;
        } else if (quote == '\0' && (c == ' ' || c == '\t' || c == '\n')) {
            if (in_word) {
                words.push_back(std::exchange(word, ""));
            }
            in_word = false;
        } else {
            word += c;
            in_word = true;
        }
    }
    if (quote != '\0') {
        throw InputError(fmt::format("--slurm: a quote is not closed in {}", in_quotes(text)));
    }
    if (in_word) {
        words.push_back(word);
    }
    return words;
}

std::vector<std::string> sbatch_options(const std::string& text) {
    std::vector<std::string> words = shell_words(text);
    for (const std::string& word : words) {
        if (is_option(word, 'a', "--ar", "--array") || is_option(word, 'J', "--j", "--job-name")) {
            throw InputError(
                fmt::format("--slurm: {} cannot be given: ljmd sets --array, whose tasks are shares of the runs, and "
                            "--job-name, by "
                            "which it finds the array in the queue. Nothing was run.\n  to limit the tasks at a time: "
                            "scontrol update "
                            "ArrayTaskThrottle=50 JobId=... when the array is submitted",
                            in_quotes(word)));
        }
    }
    return words;
}

std::string array_ranges(const std::vector<std::size_t>& tasks) {
    std::string text;
    for (std::size_t k = 0; k < tasks.size();) {
        std::size_t end = k;
        while (end + 1 < tasks.size() && tasks[end + 1] == tasks[end] + 1) {
            ++end;
        }
        text += text.empty() ? "" : ",";
        text += end == k ? fmt::format("{}", tasks[k]) : fmt::format("{}-{}", tasks[k], tasks[end]);
        k = end + 1;
    }
    return text;
}

std::vector<std::size_t> unfinished_tasks(const std::vector<bool>& finished, std::size_t tasks) {
    std::vector<bool> wanted(tasks, false);
    for (std::size_t k = 0; k < finished.size(); ++k) {
        if (!finished[k]) {
            wanted[k % tasks] = true;
        }
    }
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < tasks; ++k) {
        if (wanted[k]) {
            numbers.push_back(k + 1);
        }
    }
    return numbers;
}

SlurmArray::SlurmArray(std::string command, const fs::path& directory, const std::string& options)
    : command_(std::move(command)),
      directory_(files::absolute(directory)),
      options_(sbatch_options(options)),
      sbatch_(program_of_slurm("sbatch")),
      squeue_(program_of_slurm("squeue")),
      name_(array_name(files::canonical(directory))) {}

void SlurmArray::require_none() const {
    const auto [status, text] = answer_of(squeue_, {"--noheader", "--all", "--name=" + name_, "--format=%F %T"});
    if (status != 0) {
        throw ProcessesError(
            fmt::format("squeue fails, so it is not known whether the study is queued already. Nothing "
                        "was submitted.\n  {}",
                        said(text)));
    }
    std::istringstream lines(text);
    std::string job;
    for (std::string state; lines >> job >> state;) {
        if (state != "COMPLETING") {  // its tasks have ended, or are held by a node that does not answer
            throw InUseError(
                fmt::format("array {} of {} is queued or running. Nothing was submitted.\n  how far it is: ljmd {} "
                            "--status {}",
                            job, directory_.string(), command_, shell_word(directory_)));
        }
    }
}

std::string SlurmArray::script(std::size_t tasks, std::size_t jobs) const {
    return fmt::format(
        "#!/bin/sh\n{}"
        "exec {} {} --work \"$SLURM_ARRAY_TASK_ID/{}\" {} --jobs {}\n",
        script_mark, shell_word(this_program()), command_, tasks, shell_word(directory_), jobs);
}

std::string SlurmArray::submit(const std::vector<bool>& finished, std::size_t jobs, bool force) const {
    const std::size_t tasks = std::min(max_array_tasks, (finished.size() + jobs - 1) / jobs);
    const std::vector<std::size_t> wanted = unfinished_tasks(finished, tasks);
    const OpenDirectory folder = OpenDirectory(directory_).made_within(folder_name);
    const fs::path worker = folder.path() / script_name;
    write_output(
        worker,
        {.force = force, .mark = script_mark, .consequence = "Nothing was submitted", .instead = another_directory},
        script(tasks, jobs));
    // sbatch takes the last of two options: those above can be replaced by the user's, those below cannot.
    std::vector<std::string> arguments{fmt::format("--signal=B:USR1@{}", seconds_of_warning),
                                       fmt::format("--cpus-per-task={}", jobs),
                                       fmt::format("--output={}/%a.log", literal_pattern(folder.path()))};
    arguments.insert(arguments.end(), options_.begin(), options_.end());
    arguments.insert(arguments.end(),
                     {"--parsable", "--job-name=" + name_, "--array=" + array_ranges(wanted), worker.string()});
    const auto [status, text] = answer_of(sbatch_, arguments);
    const auto number = job_number(text);
    if (!number) {
        throw InputError(fmt::format("sbatch does not take the array. Nothing was submitted.\n  {}", said(text)));
    }
    return fmt::format("array {} of {} task{}", *number, wanted.size(), wanted.size() == 1 ? "" : "s");
}

}  // namespace ljmd
