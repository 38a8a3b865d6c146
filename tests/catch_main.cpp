#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "ljmd/execution/threads.hpp"

/// Tests run on as many threads as OMP_NUM_THREADS says, one without it.
int main(int argc, char** argv) {
    ljmd::set_thread_count(ljmd::default_thread_count());
    return Catch::Session().run(argc, argv);
}
