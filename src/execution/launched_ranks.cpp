#include "ljmd/execution/launched_ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "ljmd/core/errors.hpp"
#include "mpi_module.hpp"

namespace ljmd {

namespace {

/// Size by Open MPI's mpirun; by MPICH's and others' that speak PMI; a rank of PMIx, which has no variable for the
/// size: there srun tells it.
constexpr const char* open_mpi_size = "OMPI_COMM_WORLD_SIZE";
constexpr const char* pmi_size = "PMI_SIZE";
constexpr const char* pmix_rank = "PMIX_RANK";
constexpr const char* srun_size = "SLURM_STEP_NUM_TASKS";

bool is_set(const char* name) {
    return std::getenv(name) != nullptr;
}

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
        if (is_set(name)) {
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

std::shared_ptr<Ranks> launched_ranks(const std::filesystem::path& module) {
    const std::vector<std::string> signs = signs_of_ranks();
    if (signs.empty() || started() == 1) {
        return nullptr;
    }
    const auto refuse = [&](const std::string& why) {
        return InputError(
            fmt::format("several processes were started to share one run ({} is set), and {}. Without mpirun, one "
                        "process runs alone",
                        signs.front(), why));
    };
    if (::access(module.c_str(), F_OK) != 0) {
        if (launched_processes() == 1) {
            return nullptr;  // as far as it is told: only others could say that there are several
        }
        throw refuse(fmt::format("this ljmd was built without MPI: there is no {}", module.string()));
    }
    // Libraries of MPI load parts of their own, which look for its symbols.
    void* library = ::dlopen(module.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) {
        throw refuse(fmt::format("its part for MPI cannot be loaded: {}", ::dlerror()));
    }
    const auto join = reinterpret_cast<decltype(&ljmd_join_ranks)>(::dlsym(library, mpi_module_function));
    if (join == nullptr) {
        throw refuse(fmt::format("{} is not its part for MPI", module.string()));
    }
    std::shared_ptr<Ranks> ranks(join());
    if (!ranks) {
        throw refuse("MPI does not begin");
    }
    if (const int expected = launched_processes(); expected > 1 && ranks->size() < expected) {
        throw refuse(
            fmt::format("each of the {} is alone: its part for MPI is for another MPI than that of mpirun", expected));
    }
    return ranks->size() > 1 ? ranks : nullptr;  // a launcher that tells no number may have started one
}

}  // namespace ljmd
