#pragma once

namespace ljmd {

/// Upper limit of the number of threads.
constexpr int max_threads = 4096;

/// Number of processors that this process may run on, at least 1.
[[nodiscard]] int available_processors();

/// The number in the environment variable OMP_NUM_THREADS (the first one of a list); 1 if it is not set.
/// @throws InputError if it is not a number from 1 to max_threads
[[nodiscard]] int default_thread_count();

}  // namespace ljmd
