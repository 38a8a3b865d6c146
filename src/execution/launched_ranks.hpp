#pragma once

#include <string>
#include <vector>

namespace ljmd {

/// Names of the environment variables by which launchers tell a process that it is one of several ranks, those with
/// which this process was started; none where one of them says that it was started alone. SLURM_* alone are no sign:
/// every program of a batch job has them.
[[nodiscard]] std::vector<std::string> signs_of_ranks();

/// Whether this process is rank 0 by these variables, or was started alone. What all processes say before they are
/// joined, this one says.
[[nodiscard]] bool is_first_launched();

/// Number of processes that a launcher has started together, this one among them; 1 without a launcher. Where the
/// launcher tells ranks alone, it is the least number that fits this process's rank.
[[nodiscard]] int launched_processes();

}  // namespace ljmd
