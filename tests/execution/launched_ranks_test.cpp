#include "execution/launched_ranks.hpp"

#include "catch.hpp"

#include "core/environment_guard.hpp"

using namespace ljmd;

TEST_CASE("a process is one of several ranks if mpirun says so, not because it is in a job of Slurm") {
    const test::EnvironmentGuard slurm("SLURM_NTASKS", "4");
    CHECK(signs_of_ranks().empty());
    {
        const test::EnvironmentGuard one("OMPI_COMM_WORLD_SIZE", "1");
        CHECK(signs_of_ranks().empty());
        const test::EnvironmentGuard two("OMPI_COMM_WORLD_SIZE", "2");
        CHECK(signs_of_ranks() == std::vector<std::string>{"OMPI_COMM_WORLD_SIZE"});
    }
    {
        const test::EnvironmentGuard pmix("PMIX_RANK", "0");
        const test::EnvironmentGuard one("SLURM_STEP_NUM_TASKS", "1");
        CHECK(signs_of_ranks().empty());
        const test::EnvironmentGuard two("SLURM_STEP_NUM_TASKS", "2");
        CHECK(launched_processes() == 2);
    }
    CHECK(is_first_launched());
    CHECK(launched_processes() == 1);
    {
        // Of PMIx that tells no number: the first may be alone, the second is not.
        const test::EnvironmentGuard first("PMIX_RANK", "0");
        CHECK(launched_processes() == 1);
        const test::EnvironmentGuard second("PMIX_RANK", "1");
        CHECK(launched_processes() == 2);
        const test::EnvironmentGuard three("PMI_SIZE", "3");
        CHECK(launched_processes() == 3);
    }
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"}) {
        {
            const test::EnvironmentGuard first(name, "0");
            CHECK(is_first_launched());
        }
        const test::EnvironmentGuard second(name, "1");
        CHECK_FALSE(is_first_launched());
    }
}
