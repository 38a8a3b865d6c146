#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/detail/run/interruption.hpp"

namespace ljmd {

/// Tasks of an array at most: clusters number them up to MaxArraySize - 1, which is 1000 by default.
inline constexpr std::size_t max_array_tasks = 1000;

/// The words of a text as a shell separates them: by spaces, with quotes and backslashes, and nothing else.
/// @throws InputError  a quote is not closed
[[nodiscard]] std::vector<std::string> shell_words(const std::string& text);

/// Options of sbatch that a user gives, as words.
/// @throws InputError  a quote is not closed, an option has no value, or a word is none of the options that are allowed
/// by name. Not allowed are those that say which jobs there are, by which names and on which clusters, and what sbatch
/// prints: --array, --job-name, --clusters, --wait, --test-only, --quiet, ...
[[nodiscard]] std::vector<std::string> sbatch_options(const std::string& text);

/// The tasks of an array as sbatch wants them: "1-3,7". @param tasks  in increasing order
[[nodiscard]] std::string array_ranges(const std::vector<std::size_t>& tasks);

/// Numbers of tasks, counted from 1, whose shares have unfinished runs.
/// @param finished  for each run of the study
/// @param tasks     their number
[[nodiscard]] std::vector<std::size_t> unfinished_tasks(const std::vector<bool>& finished, std::size_t tasks);

/// A study whose runs are the tasks of a job array in Slurm. Each task is a worker of the study. Slurm is asked by
/// squeue and sbatch, once when an array is submitted, without those variables that make them look or act elsewhere;
/// how far the runs are is told by their directories alone.
class SlurmArray {
  public:
    /// @param command    "sweep" or "reproduce"
    /// @param directory  of the study; the name of the array is made from its canonical path
    /// @param options    of sbatch, in one text, as sbatch_options() takes them
    /// @param interruption  stops a program of Slurm that does not answer
    /// @param seconds       for which an answer is waited
    /// @throws InputError  as sbatch_options(), or sbatch or squeue is not on this computer
    SlurmArray(std::string command, const std::filesystem::path& directory, const std::string& options,
               const Interruption& interruption, double seconds = 300.0);

    /// @throws InUseError  an array of this study is queued or running
    /// @throws ProcessesError  squeue fails, e.g. because the controller does not answer, does not answer in time, or
    /// prints what is no queue  @throws Interrupted
    void require_none() const;

    /// Submit an array for the runs that are not finished.
    /// @param jobs  runs at a time in each task
    /// @param force  whether a script that ljmd has not written is replaced
    /// @return "array 17 of 3 tasks"
    /// @throws InputError  sbatch refuses it; OutputRefused as require_writable(); FileError
    /// @throws ProcessesError  it is not known whether sbatch has taken it  @throws Interrupted
    [[nodiscard]] std::string submit(const std::vector<bool>& finished, std::size_t jobs, bool force) const;

  private:
    struct Answer {
        int status;
        std::string text;    ///< its stdout
        std::string errors;  ///< its stderr
    };
    [[nodiscard]] Answer answer_of(const std::filesystem::path& program, std::vector<std::string> arguments,
                                   std::vector<std::string> without, const std::string& consequence) const;
    [[nodiscard]] std::string script(std::size_t tasks, std::size_t jobs) const;

    std::string command_;
    std::filesystem::path directory_;  ///< as it was given, absolute: a computer of the cluster may have other links
    std::vector<std::string> options_;
    std::filesystem::path sbatch_;
    std::filesystem::path squeue_;
    std::string name_;
    Interruption interruption_;
    double seconds_;
};

}  // namespace ljmd
