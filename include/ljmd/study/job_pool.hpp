#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/run/interruption.hpp"

namespace ljmd {

/// A command line of this program, to be run as a process.
struct Job {
    std::vector<std::string> arguments;
    std::filesystem::path output;  ///< file for its messages
};

/// Returns the next job of a line after one of its jobs has ended; nothing at the end of the line.
/// @param line         its number, from 0
/// @param exit_status  of the job that ended
using NextJob = std::function<std::optional<Job>(std::size_t line, int exit_status)>;

/// Run lines of jobs, several lines at a time; the jobs of a line run one after the other.
///
/// A signal that asks this program to stop is passed to all jobs, which stop with checkpoints; no further job is
/// started. Jobs are in process groups of their own, so Ctrl-C reaches them only in this way.
///
/// @param program  usually this one
/// @param first    the first job of each line
/// @param at_most  lines at a time, >= 1
/// @throws Interrupted  after all jobs have ended  @throws FileError  a job cannot be started; the others are then
/// stopped
void run_jobs(const std::filesystem::path& program, const std::vector<Job>& first, int at_most, const NextJob& next,
              const Interruption& interruption = Interruption());

/// The executable file of this program. @throws FileError
[[nodiscard]] std::filesystem::path this_program();

}  // namespace ljmd
