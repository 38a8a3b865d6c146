#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/studies/study_mode.hpp"
#include "core/document.hpp"
#include "io/files/open_directory.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "study/run_lines.hpp"
#include "study/slurm_array.hpp"

/// The steps that `ljmd sweep` and `ljmd reproduce` have in common: prepare a directory, work on its runs, gather.
namespace ljmd {

/// A study as its commands name it.
struct StudyWords {
    std::string command;  ///< "sweep"
    std::string request;  ///< "DECK --grid ...", what is given to the command
    std::string one;      ///< "point"
};

[[nodiscard]] const StudyWords& sweep_words();
[[nodiscard]] const StudyWords& reproduction_words();

/// Tell how far the runs in a directory are. @throws InputError  the directory holds no study of this kind
void print_status(const StudyWords& words, const std::filesystem::path& directory, bool as_json);

/// Say that a directory is prepared.
void print_prepared(const StudyWords& words, const std::filesystem::path& directory, std::size_t runs, bool as_json);

/// Says that a run has come to its end, as the done-th of all; empty: nothing is said.
using TellRun = std::function<void(const RunLine& line, std::size_t done, std::size_t all)>;

/// Bring runs to their ends, and warn of those that fail.
/// @param directory  where they are: they are started by path
/// @throws InUseError  it was moved meanwhile  @throws Interrupted, FileError
void run_all(const std::vector<RunLine*>& lines, const OpenDirectory& directory, int jobs,
             const Interruption& interruption, const TellRun& tell);

/// The same for the share of a worker.
/// @param lines  of the whole study
/// @throws InputError   the share or the wall time cannot be read
/// @throws PhysicsError  if any of the share have failed
void work_on(const StudyWords& words, const StudyMode& mode, const std::vector<RunLine*>& lines,
             const OpenDirectory& directory, int jobs, const TellRun& tell);

/// wait_for_runs() until a signal comes; what is waited for is told. @throws Interrupted
void wait_for_writing_runs(const std::filesystem::path& folder);

/// How far the runs of a study are.
struct Gathered {
    std::vector<bool> finished;  ///< for each line
    std::size_t missing = 0;     ///< lines that are not at their ends
    std::size_t failed = 0;      ///< of these, lines that were tried and have failed

    /// Whether each run is at its end or has failed.
    [[nodiscard]] bool ended() const { return missing == failed; }
};

/// Look how far each line is. Lines that are at their ends have their results then, and those that failed their
/// failures.
[[nodiscard]] Gathered gathered(const std::vector<RunLine*>& lines);

/// @throws PhysicsError  there are failures
/// @param all    number of runs
/// @param again  what tries them again: "the same command tries them again"
void throw_failures(const StudyWords& words, const std::vector<std::string>& failures, std::size_t all,
                    const std::string& again);

/// How runs are submitted, and what is printed.
struct SubmitOptions {
    int jobs = 0;  ///< runs at a time in each task; 0: one
    bool force = false;
    bool json = false;
};

/// Gather what is finished, and submit what is missing as a job array. Tell both, unless the study has ended.
/// @param print  print the table of a study that has ended, and return why runs have failed
/// @throws PhysicsError  it has ended, and some have failed
void submit_missing(const StudyWords& words, const SlurmArray& array, const std::vector<RunLine*>& lines,
                    const OpenDirectory& directory, const SubmitOptions& options,
                    const std::function<std::vector<std::string>()>& print);

}  // namespace ljmd
