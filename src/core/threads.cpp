#include "ljmd/core/threads.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <limits>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

int threads_in_use = 1;

}  // namespace

int available_processors() {
    return std::max(1, omp_get_num_procs());
}

int default_thread_count() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody writes the environment
    return std::getenv("OMP_NUM_THREADS") != nullptr ? std::clamp(omp_get_max_threads(), 1, most_threads) : 1;
}

int thread_count() {
    return threads_in_use;
}

void set_thread_count(int count) {
    if (count < 1) {
        throw ContractViolation(fmt::format("{} threads", count));
    }
    threads_in_use = count;
}

void for_each_block(Index count, Index block_length, BlockFunction function) {
    const Index blocks = (count + block_length - 1) / block_length;
    const auto call = [&](Index block) { function(block * block_length, std::min((block + 1) * block_length, count)); };
    if (threads_in_use == 1 || blocks < 2) {
        for (Index block = 0; block < blocks; ++block) {
            call(block);
        }
        return;
    }
    // An exception may not leave a parallel region. Of several the one of the first block is kept, as in a serial loop.
    std::exception_ptr failure;
    Index failed = std::numeric_limits<Index>::max();
#pragma omp parallel for schedule(static) num_threads(threads_in_use)
    for (Index block = 0; block < blocks; ++block) {
        try {
            call(block);
        } catch (...) {
#pragma omp critical(ljmd_block_failure)
            if (block < failed) {
                failed = block;
                failure = std::current_exception();
            }
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

}  // namespace ljmd
