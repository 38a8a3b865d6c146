#include "ljmd/app/wait_policy.hpp"

#include <unistd.h>

#include <cstdlib>

namespace ljmd {

void wait_actively(int threads, char** argv) {
    // NOLINTBEGIN(concurrency-mt-unsafe): there is one thread yet
    if (threads < 2 || std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) {
        return;
    }
    setenv("OMP_WAIT_POLICY", "active", 1);
    // NOLINTEND(concurrency-mt-unsafe)
    execv("/proc/self/exe", argv);
}

}  // namespace ljmd
