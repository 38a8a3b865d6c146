#pragma once

#include "execution/threads.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd::test {

/// As many threads as OMP_NUM_THREADS says, one without it, so that a test can be run with any number.
inline Execution test_execution() {
    return Execution({.threads = default_thread_count()});
}

inline Execution with_threads(int threads) {
    return Execution({.threads = threads});
}

}  // namespace ljmd::test
