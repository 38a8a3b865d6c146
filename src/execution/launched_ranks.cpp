#include "execution/launched_ranks.hpp"

#include <cstdlib>

namespace ljmd {

namespace {

/// Size by Open MPI's mpirun; by MPICH's and others' that speak PMI; a rank of PMIx, which has no variable for the
/// size: there srun tells it.
constexpr const char* open_mpi_size = "OMPI_COMM_WORLD_SIZE";
constexpr const char* pmi_size = "PMI_SIZE";
constexpr const char* pmix_rank = "PMIX_RANK";
constexpr const char* srun_size = "SLURM_STEP_NUM_TASKS";

/// Number of processes that the launcher has started; 0: it does not say.
int started() {
    for (const char* name : {open_mpi_size, pmi_size, srun_size}) {
        if (const char* text = std::getenv(name)) {
            return std::atoi(text);
        }
    }
    return 0;
}

/// Rank of this process; 0 without a launcher.
int launched_rank() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", pmix_rank}) {
        if (const char* text = std::getenv(name)) {
            return std::atoi(text);
        }
    }
    return 0;
}

}  // namespace

std::vector<std::string> signs_of_ranks() {
    std::vector<std::string> found;
    for (const char* name : {open_mpi_size, pmi_size, pmix_rank}) {
        if (std::getenv(name) != nullptr && started() != 1) {
            found.emplace_back(name);
        }
    }
    return found;
}

bool is_first_launched() {
    return launched_rank() == 0;
}

int launched_processes() {
    if (signs_of_ranks().empty()) {
        return 1;
    }
    const int told = started();
    return told > 0 ? told : launched_rank() + 1;
}

}  // namespace ljmd
