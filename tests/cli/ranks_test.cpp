#include "cli/ranks.hpp"

#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

// What ranks do together takes several processes: tests/mpi runs the program in them.

TEST_CASE("ranks are joined only if several processes were started, and by the module alone") {
    const ProgramModule nowhere("MPI", "packages", "/nowhere/ljmd_mpi.so");
    CHECK(mpi_module().path().filename() == "ljmd_mpi.so");
    CHECK(launched_ranks(nowhere) == nullptr);
    {
        const test::EnvironmentGuard one("OMPI_COMM_WORLD_SIZE", "1");
        CHECK(launched_ranks(nowhere) == nullptr);
    }
    {
        const test::EnvironmentGuard pmix("PMIX_RANK", "0");
        CHECK(launched_ranks(nowhere) == nullptr);  // it may be alone
        const test::EnvironmentGuard one("SLURM_STEP_NUM_TASKS", "1");
        CHECK(launched_ranks(nowhere) == nullptr);
        const test::EnvironmentGuard two("SLURM_STEP_NUM_TASKS", "2");
        CHECK_THROWS_AS(launched_ranks(nowhere), InputError);
    }
    {
        const test::EnvironmentGuard second("PMIX_RANK", "1");
        CHECK_THROWS_AS(launched_ranks(nowhere), InputError);
    }
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
        const test::EnvironmentGuard two(name, "2");
        CHECK_THROWS_WITH(launched_ranks(nowhere),
                          Contains(name) && Contains("built without MPI: there is no ") && Contains("ljmd_mpi.so"));
    }
}
