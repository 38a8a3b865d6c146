#include "study/slurm_array.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/open_directory.hpp"
#include "io/files/process.hpp"
#include "io/files/program_module.hpp"
#include "io/files/scratch_directory.hpp"
#include "io/files/shell_word.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"

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

/// The number of a job, which is all that `sbatch --parsable` prints: "17" or "17;cluster".
std::optional<std::string> job_number(const std::string& text) {
    std::istringstream words(text);
    std::string word;
    std::string more;
    if (!(words >> word) || words >> more) {
        return std::nullopt;
    }
    const std::string number = word.substr(0, word.find(';'));
    const bool is_number =
        !number.empty() && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
    return is_number ? std::optional(number) : std::nullopt;
}

enum class Takes { nothing, value, value_behind_equals };

struct SbatchOption {
    std::string name;
    char letter;  ///< '\0': none
    Takes takes;
};

/// What a user may ask sbatch for: where, when and with what the tasks run, each with its letter. Others change which
/// jobs there are, where they are found, or what sbatch prints.
constexpr std::array<std::pair<Takes, std::string_view>, 3> allowed{{
    {Takes::value,
     "account/A acctg-freq batch bb bbf begin/b chdir/D comment constraint/C core-spec/S cores-per-socket "
     "cpu-freq cpus-per-task/c deadline delay-boot dependency/d distribution/m error/e exclude/x export "
     "extra-node-info/B gpus/G gpus-per-node gpus-per-task gres gres-flags hint kill-on-invalid-dep "
     "licenses/L mail-type mail-user mcs-label mem mem-bind mem-per-cpu mem-per-gpu mincpus network "
     "nodelist/w nodes/N ntasks/n ntasks-per-node open-mode output/o partition/p power prefer priority "
     "profile qos/q reservation signal sockets-per-node switches thread-spec threads-per-core time/t "
     "time-min tmp wckey"},
    {Takes::value_behind_equals, "exclusive nice propagate"},
    {Takes::nothing,
     "contiguous hold/H no-requeue overcommit/O oversubscribe/s reboot requeue spread-job use-min-nodes"},
}};

std::vector<SbatchOption> allowed_options() {
    std::vector<SbatchOption> options;
    for (const auto& [takes, words] : allowed) {
        std::istringstream text{std::string(words)};
        for (std::string word; text >> word;) {
            const std::size_t slash = word.find('/');
            options.push_back({word.substr(0, slash), slash < word.size() ? word[slash + 1] : '\0', takes});
        }
    }
    return options;
}

/// What the option that a word begins takes; nothing if that is not allowed.
/// @param with_value  receives whether its value is in the word
std::optional<Takes> taken_by(const std::string& word, bool& with_value) {
    const bool is_long = word.starts_with("--");
    if (!is_long && (word.size() < 2 || word[0] != '-')) {
        return std::nullopt;
    }
    const std::size_t equals = word.find('=');
    const std::string name = is_long ? word.substr(2, equals - 2) : "";
    with_value = is_long ? equals != std::string::npos : word.size() > 2;
    for (const SbatchOption& option : allowed_options()) {
        if (is_long ? option.name == name : option.letter == word[1]) {
            return option.takes == Takes::nothing && with_value ? std::nullopt : std::optional(option.takes);
        }
    }
    return std::nullopt;
}

std::string names_of_allowed() {
    std::vector<std::string> names;
    for (const SbatchOption& option : allowed_options()) {
        const std::string letter = option.letter == '\0' ? "" : fmt::format(" (-{})", option.letter);
        names.push_back("--" + option.name + letter);
    }
    std::ranges::sort(names);
    return fmt::format("{}", fmt::join(names, ", "));
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
    for (std::size_t k = 0; k < words.size(); ++k) {
        bool with_value = false;
        const std::optional<Takes> takes = taken_by(words[k], with_value);
        if (!takes) {
            throw InputError(fmt::format(
                "--slurm: {} cannot be given. Nothing was run.\n  ljmd says itself which tasks the array has, "
                "its name and what sbatch prints; it is looked for on the cluster of this computer\n  options "
                "that can be given, one in a word: {}",
                in_quotes(words[k]), names_of_allowed()));
        }
        if (takes == Takes::value && !with_value && ++k == words.size()) {
            throw InputError(fmt::format("--slurm: {} needs a value. Nothing was run.", in_quotes(words.back())));
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

SlurmArray::SlurmArray(std::string command, const fs::path& directory, const std::string& options,
                       const Interruption& interruption, double seconds)
    : command_(std::move(command)),
      directory_(files::absolute(directory)),
      options_(sbatch_options(options)),
      sbatch_(program_of_slurm("sbatch")),
      squeue_(program_of_slurm("squeue")),
      name_(array_name(files::canonical(directory))),
      interruption_(interruption),
      seconds_(seconds) {}

/// Run a program that answers at once.
/// @param without      variables that it does not get, as in Process
/// @param consequence  of no answer, for a message
SlurmArray::Answer SlurmArray::answer_of(const fs::path& program, std::vector<std::string> arguments,
                                         std::vector<std::string> without, const std::string& consequence) const {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds_);
    const ScratchDirectory scratch;
    const fs::path output = scratch.path() / "output";
    const fs::path errors = scratch.path() / "errors";
    ChildProcess child({.program = program,
                        .arguments = std::move(arguments),
                        .directory = ".",
                        .output = output,
                        .errors = errors,
                        .without = std::move(without),
                        .kept = true});
    const auto status = child.wait_while([&] { return !interruption_.request() && Clock::now() < end; });
    if (!status) {
        child.stop();
        const std::string name = program.filename().string();
        if (const auto asked = interruption_.request()) {
            throw Interrupted(fmt::format("{} was stopped before it answered. {}", name, consequence),
                              asked->exit_code());
        }
        throw ProcessesError(
            fmt::format("{} has not answered within {:g} s, and was stopped. {}", name, seconds_, consequence));
    }
    return {*status, read_input(output), read_input(errors)};
}

void SlurmArray::require_none() const {
    const std::string unknown = "It is not known whether the study is queued already, and nothing was submitted.";
    // squeue takes filters and formats also from variables, SQUEUE_PARTITION for one, which would hide an array.
    const auto [status, text, errors] = answer_of(squeue_, {"--noheader", "--all", "--name=" + name_, "--format=%F %T"},
                                                  {"SQUEUE_", "SLURM_CLUSTERS="}, unknown);
    if (status != 0) {
        throw ProcessesError(fmt::format("squeue fails with exit status {}. {}\n  {}", status, unknown, said(errors)));
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string job;
        std::string state;
        std::string more;
        if (!(words >> job >> state) || words >> more || !job_number(job)) {
            throw ProcessesError(fmt::format("squeue prints what is no job. {}\n  {}", unknown, said(line)));
        }
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
    const std::string unknown = fmt::format("It is not known whether an array is queued: squeue --name={}", name_);
    const auto [status, text, errors] = answer_of(sbatch_, arguments,
                                                  {"SBATCH_WAIT=", "SBATCH_ARRAY_INX=", "SBATCH_JOB_NAME=",
                                                   "SBATCH_TEST_ONLY=", "SBATCH_CLUSTERS=", "SLURM_CLUSTERS="},
                                                  unknown);
    const auto number = job_number(text);
    if (status != 0 && text.find_first_not_of(" \n") == std::string::npos) {
        throw InputError(fmt::format("sbatch does not take the array. Nothing was submitted.\n  {}", said(errors)));
    }
    if (status != 0 || !number) {
        throw ProcessesError(fmt::format("sbatch ends with exit status {}, and prints {}. {}\n  {}", status,
                                         in_quotes(said(text)), unknown, said(errors)));
    }
    return fmt::format("array {} of {} task{}", *number, wanted.size(), wanted.size() == 1 ? "" : "s");
}

}  // namespace ljmd
