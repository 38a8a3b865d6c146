#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

class CallerAccount;

/// What two threads write lies so far apart [bytes]. Processors load lines of 64 bytes in pairs.
inline constexpr std::size_t cache_lines = 128;

/// Reference to a function of (first, last), which must outlive the call.
class BlockFunction {
  public:
    template <class F, class = std::enable_if_t<!std::is_same_v<std::remove_cvref_t<F>, BlockFunction>>>
    BlockFunction(F&& function)  // NOLINT(*-explicit-*): made from lambdas at calls of for_each_block
        : object_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* object, Index first, Index last) {
              (*static_cast<std::remove_reference_t<F>*>(object))(first, last);
          }) {}

    void operator()(Index first, Index last) const { call_(object_, first, last); }

  private:
    void* object_;
    void (*call_)(void*, Index, Index);
};

/// The system refuses a thread. The message says how many it allows.
class ThreadsError : public Error {
  public:
    using Error::Error;
};

/// Number of this thread in the loop that it takes part in: 0 for the caller of for_each_block, 1 to ThreadTeam::size()
/// - 1 for the others. It is the index of memory that each thread has for itself.
[[nodiscard]] int number_in_team();

/// Threads that share the blocks of a loop: the calling thread, and workers that live as long as the team.
///
/// Each thread has a share of consecutive blocks, the same in every loop with that many blocks of that work, so its
/// atoms stay in its cache. Which thread computes a block changes no result. The caller makes use of that:
///
/// - A waiting thread spins for about as long as it takes to wake a sleeping thread (tens of microseconds; a worker up
///   to 1 ms after long work), then sleeps.
/// - Blocks that a worker has not begun after 20 microseconds, or that belong to a worker still asleep, are computed by
///   the caller.
/// - If the caller waits longer for a worker than its blocks have saved, because another program has its processor or
///   because the loops are too small, the worker is left out for ten times the loss (src/execution/worker_account.hpp).
///   So is the last worker if the caller has less of a processor with the team than alone, where other programs have
///   the rest (src/execution/caller_account.hpp). So a team is at most about a tenth slower than the caller alone, a
///   sixth where loops are shorter than 50 microseconds.
class ThreadTeam {
  public:
    /// @param threads  number of threads, the caller included  @pre threads >= 1
    /// @throws ThreadsError if the system refuses that many; none is kept then
    explicit ThreadTeam(int threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    [[nodiscard]] int size() const { return static_cast<int>(workers_.size()) + 1; }

    /// Call function(first, last) for [0, L), [L, 2 L), ... up to `count`, with L = block_length. Returns when all are
    /// done.
    ///
    /// The caller computes all blocks if there is only one, if the team is busy (a nested loop, or one in another
    /// thread), and in a child process made by fork(), which has no workers.
    /// @param work_before  the work of all blocks before block k, in any unit, for k = 0 ... number of blocks: threads
    ///                     get shares of equal work. Without it, of equally many blocks.
    /// @pre blocks do not write what other blocks read or write; block_length > 0
    /// @throws the exception of the first block that threw; later blocks may not have been called
    void for_each_block(Index count, Index block_length, BlockFunction function,
                        std::span<const std::int64_t> work_before = {});

  private:
    struct Caller;
    class Worker;
    void share_out(Caller& caller);
    [[nodiscard]] bool in_child_process() const;

    int forks_;  ///< number of forks behind this process when the team was made
    std::unique_ptr<CallerAccount> account_;
    std::atomic<bool> at_work_ = false;
    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<Worker*> present_;  ///< workers that share the present loop
};

}  // namespace ljmd
