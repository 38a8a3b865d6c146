#pragma once

#include <CLI/CLI.hpp>

#include "cli/studies/study_mode.hpp"

namespace ljmd {

/// Add --prepare, --work, --walltime, --slurm and --status to the command of a study, which has --jobs, --force,
/// --quiet,
/// --json, --out and others already. Options that have no effect together are refused.
void add_study_mode(CLI::App& command, StudyMode& mode);

}  // namespace ljmd
