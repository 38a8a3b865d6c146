#pragma once

#include <optional>
#include <string>

namespace ljmd {

/// How a command brings the runs of its study to their ends. By default it runs all of them itself; at most one of
/// `prepare`, `work`, `slurm` and `status` is given.
struct StudyMode {
    bool prepare = false;                ///< write the directory, run nothing
    std::string work{};                  ///< "K/T": the share of this worker in a prepared directory
    std::optional<std::string> slurm{};  ///< options of sbatch: the runs are tasks of a job array
    bool status = false;                 ///< tell how far the runs in a directory are
    std::string walltime{};              ///< of a worker: stop after that long with checkpoints
};

}  // namespace ljmd
