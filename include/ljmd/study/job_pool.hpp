#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/run/interruption.hpp"

namespace ljmd {

/// One command line of this program, to be run as a process of its own.
struct Job {
    std::vector<std::string> arguments;
    std::filesystem::path output;  ///< file for what it says
};

/// What is done next in a line of jobs when one of them has ended; nothing: the line is at its end.
/// @param line         its number, from 0
/// @param exit_status  of the job that has ended
using NextJob = std::function<std::optional<Job>(std::size_t line, int exit_status)>;

/// Run lines of jobs, the jobs of a line one after the other, several lines at a time.
///
/// A signal that asks this program to stop is handed to all jobs, which stop with checkpoints, and no further one is
/// started. Keys on the terminal reach them in no other way.
///
/// @param program  the one to run: this one, usually
/// @param first    the first job of each line
/// @param at_most  lines at a time, >= 1
/// @throws Interrupted  when all jobs have ended  @throws FileError  one cannot be started; the others are stopped, too
void run_jobs(const std::filesystem::path& program, const std::vector<Job>& first, int at_most, const NextJob& next,
              const Interruption& interruption = Interruption());

/// The file of the program that is running. @throws FileError
[[nodiscard]] std::filesystem::path this_program();

}  // namespace ljmd
