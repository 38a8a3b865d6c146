#pragma once

#include <atomic>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// A reference to something that can be called with (first, last); it must outlive the call.
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

/// The system refuses a thread. The text tells how many it allows.
class ThreadsError : public Error {
  public:
    using Error::Error;
};

/// Number of this thread among those that share the loop in which it is: 0 for the one that called for_each_block, less
/// than ThreadTeam::size() for the others. For memory that each thread of a loop has for itself.
[[nodiscard]] int number_in_team();

/// Threads that share the blocks of a loop: the one that calls, and workers that live as long as the team.
///
/// Each thread has a share of consecutive blocks, the same in every loop of that many blocks, so it finds its atoms in
/// its cache. Which thread computes a block changes no result, and the caller makes use of that:
///
/// - Whoever waits looks again and again for some ten microseconds, as long as it takes to wake a sleeping thread, then
///   sleeps.
/// - Blocks that a worker has not begun by then, or that belong to a worker still asleep, are computed by the caller.
/// - A worker for which the caller waits longer than its blocks saved, because another program has its processor or
///   because the loops are too small, is left out for ten times the loss (src/execution/worker_account.hpp). So a team
///   is at most about a tenth slower than the caller alone.
class ThreadTeam {
  public:
    /// @param threads  the caller's included  @pre threads >= 1
    /// @throws ThreadsError if the system refuses so many; none is left then
    explicit ThreadTeam(int threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    [[nodiscard]] int size() const { return static_cast<int>(workers_.size()) + 1; }

    /// Call function(first, last) for [0, L), [L, 2 L), ... up to `count`, L = block_length. Returns when all are done.
    ///
    /// The caller computes all blocks when there is only one, when the team is at work already (a loop within a loop,
    /// or in another thread), and in a child process made by fork(), which has no workers.
    /// @pre blocks do not write what other blocks read or write; block_length > 0
    /// @throws what the first block that threw has thrown; later blocks may not have been called
    void for_each_block(Index count, Index block_length, BlockFunction function);

  private:
    struct Caller;
    class Worker;
    void share_out(Caller& caller);
    [[nodiscard]] bool in_child_process() const;
    double time_without_processor();

    int forks_;                   ///< of this process when the team was made
    double processor_lag_ = 0.0;  ///< see time_without_processor
    std::atomic<bool> at_work_ = false;
    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<Worker*> present_;  ///< those that share the present loop
};

}  // namespace ljmd
