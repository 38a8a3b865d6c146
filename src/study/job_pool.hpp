#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/run/interruption.hpp"

namespace ljmd {

/// A command line of this program, to be run as a process.
struct Job {
    std::vector<std::string> arguments;
    std::filesystem::path output;  ///< file for its messages
    int output_descriptor = -1;    ///< that file, if it is open; -1: it is written anew
};

/// Returns the first job of a line when its turn has come; nothing if it has none.
/// @param line  its number, from 0
using FirstJob = std::function<std::optional<Job>(std::size_t line)>;

/// Returns the next job of a line after one of its jobs has ended; nothing at the end of the line.
/// @param exit_status  of the job that ended
using NextJob = std::function<std::optional<Job>(std::size_t line, int exit_status)>;

/// Run lines of jobs, several lines at a time; the jobs of a line run one after the other.
///
/// When a signal asks this program to stop, or its wall time is over, all jobs are asked to stop with checkpoints; no
/// further job is started. Jobs are in process groups of their own, so Ctrl-C reaches them only in this way.
///
/// @param program  usually this one
/// @param lines    their number
/// @param at_most  lines at a time, >= 1
/// @throws Interrupted  after all jobs have ended  @throws FileError  a job cannot be started; the others are then
/// stopped
void run_jobs(const std::filesystem::path& program, std::size_t lines, int at_most, const FirstJob& first,
              const NextJob& next, const Interruption& interruption = Interruption());

}  // namespace ljmd
