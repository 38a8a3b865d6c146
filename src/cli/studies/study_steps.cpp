#include "cli/studies/study_steps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "io/files/file_system.hpp"
#include "io/files/shell_word.hpp"
#include "ljmd/core/errors.hpp"
#include "study/study_report.hpp"
#include "study/work_share.hpp"

namespace ljmd {

const StudyWords& sweep_words() {
    static const StudyWords words{"sweep", "DECK --grid ...", "point"};
    return words;
}

const StudyWords& reproduction_words() {
    static const StudyWords words{"reproduce", "TABLE", "row"};
    return words;
}

void print_status(const StudyWords& words, const std::filesystem::path& directory, bool as_json) {
    if (!holds_study(directory)) {
        throw InputError(fmt::format("--status: {} holds no study; `ljmd {} {} --prepare` makes one",
                                     directory.string(), words.command, words.request));
    }
    print_document(study_report(directory, result_columns()), as_json);
}

void print_prepared(const StudyWords& words, const std::filesystem::path& directory, std::size_t runs, bool as_json) {
    print_document({{{"directory", directory.string()}, {"prepared", static_cast<Index>(runs)}},
                    fmt::format("{} {}{} prepared in {}\nto run them: ljmd {} --work K/T {}\n", runs, words.one,
                                runs == 1 ? "" : "s", directory.string(), words.command, shell_word(directory))},
                   as_json);
}

void throw_failures(const StudyWords& words, const std::vector<std::string>& failures, std::size_t all,
                    const std::string& again) {
    if (!failures.empty()) {
        throw PhysicsError(fmt::format("{} of {} {}s failed; {}\n  {}", failures.size(), all, words.one, again,
                                       fmt::join(failures, "\n  ")));
    }
}

void run_all(const std::vector<RunLine*>& lines, const OpenDirectory& directory, int jobs,
             const Interruption& interruption, const TellRun& tell) {
    run_lines(
        lines, jobs, interruption,
        [&](const RunLine& line, std::size_t done) {
            directory.require_at_its_path();
            if (!line.failure().empty()) {
                warn(line.failure());
            } else if (tell) {
                tell(line, done, lines.size());
            }
        },
        print_message);
}

void work_on(const StudyWords& words, const StudyMode& mode, const std::vector<RunLine*>& lines,
             const OpenDirectory& directory, int jobs, const TellRun& tell) {
    const std::vector<RunLine*> ours = lines_of(work_share(mode.work), lines);
    run_all(ours, directory, jobs, until_signal(wall_time(mode.walltime)), tell);
    std::vector<std::string> failures;
    for (const RunLine* line : ours) {
        if (!line->failure().empty()) {
            failures.push_back(line->failure());
        }
    }
    throw_failures(words, failures, ours.size(), "the same command tries them again");
}

void wait_for_writing_runs(const std::filesystem::path& folder) {
    wait_for_runs(folder, until_signal(), print_message);
}

Gathered gathered(const std::vector<RunLine*>& lines) {
    Gathered found;
    for (RunLine* line : lines) {
        const bool finished = !line->begin();
        found.finished.push_back(finished);
        if (finished) {
            continue;
        }
        ++found.missing;
        if (const std::string failure = recorded_failure(line->run().log); !failure.empty()) {
            ++found.failed;
            line->set_failure(fmt::format("{}: {}", line->run().name, failure));
        }
    }
    return found;
}

namespace {

/// Tell what was gathered of a study that has not come to its end, and what was submitted.
void print_submitted(const StudyWords& words, const std::filesystem::path& directory, const Gathered& found,
                     const std::string& submitted, bool as_json) {
    const std::size_t all = found.finished.size();
    print_document({{{"directory", directory.string()},
                     {"runs", static_cast<Index>(all)},
                     {"finished", static_cast<Index>(all - found.missing)},
                     {"failed", static_cast<Index>(found.failed)},
                     {"submitted", submitted}},
                    fmt::format("{}: {} of {} {}s are finished\nsubmitted: {}\nhow far they are: ljmd {} --status {}\n"
                                "the same command gathers what is finished, and submits again what is missing\n",
                                directory.string(), all - found.missing, all, words.one, submitted, words.command,
                                shell_word(directory))},
                   as_json);
}

}  // namespace

void submit_missing(const StudyWords& words, const SlurmArray& array, const std::vector<RunLine*>& lines,
                    const OpenDirectory& directory, const SubmitOptions& options,
                    const std::function<std::vector<std::string>()>& print) {
    const Gathered found = gathered(lines);
    const std::string submitted =
        found.missing > 0
            ? array.submit(found.finished, static_cast<std::size_t>(std::max(1, options.jobs)), options.force)
            : "";
    if (!found.ended()) {
        print_submitted(words, directory.path(), found, submitted, options.json);
        return;
    }
    throw_failures(words, print(), lines.size(),
                   submitted.empty() ? "to begin them anew, remove their directories"
                                     : fmt::format("they are tried again: {}", submitted));
}

}  // namespace ljmd
