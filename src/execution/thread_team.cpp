#include "execution/thread_team.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <time.h>  // NOLINT(modernize-deprecated-headers): POSIX's, for the clock of a thread

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include "execution/caller_account.hpp"
#include "execution/signals_blocked.hpp"
#include "execution/spin_until.hpp"
#include "execution/worker_account.hpp"

namespace ljmd {

namespace {

using Clock = WorkerAccount::Clock;
using Nanoseconds = WorkerAccount::Nanoseconds;

/// How long the caller waits for a worker that is awake before it takes over the blocks that the worker has not begun.
constexpr std::chrono::microseconds patience{20};
/// How long a thread spins before it sleeps: about as long as it takes to wake it. A worker may spin as long as it has
/// just worked, because the caller's share may take longer.
constexpr std::chrono::microseconds shortest_spin{50};
constexpr std::chrono::microseconds longest_spin{1000};

thread_local int number_of_this_thread = 0;

/// Marks this thread as the caller of its loop.
class IsCaller {
  public:
    IsCaller() : before_(std::exchange(number_of_this_thread, 0)) {}
    ~IsCaller() { number_of_this_thread = before_; }
    IsCaller(const IsCaller&) = delete;
    IsCaller& operator=(const IsCaller&) = delete;

  private:
    int before_;
};

/// Processor time of the calling thread.
Nanoseconds processor_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::atomic<int> forks = 0;  // number of forks behind this process since the first team was made

struct Loop {
    Index count;
    Index block_length;
    BlockFunction function;
    std::span<const std::int64_t> work_before;  // see ThreadTeam::for_each_block(); empty: blocks take equally long

    [[nodiscard]] Index blocks() const { return (count + block_length - 1) / block_length; }
    void call(Index block) const { function(block * block_length, std::min((block + 1) * block_length, count)); }
    /// Work of blocks [first, last).
    [[nodiscard]] double work(Index first, Index last) const {
        return static_cast<double>(work_before.empty() ? last - first : before(last) - before(first));
    }
    /// First block of share k of so many, each of about the same work. Every share has a block.
    [[nodiscard]] Index share_begin(Index k, Index shares) const {
        if (k == shares) {
            return blocks();
        }
        if (work_before.empty()) {
            return k * (blocks() / shares) + std::min(k, blocks() % shares);
        }
        const auto wanted = static_cast<std::int64_t>(static_cast<double>(before(blocks())) * static_cast<double>(k) /
                                                      static_cast<double>(shares));
        auto found = std::lower_bound(work_before.begin(), work_before.end(), wanted);
        if (found != work_before.begin() && wanted - *(found - 1) < *found - wanted) {
            --found;
        }
        return std::clamp<Index>(found - work_before.begin(), k, blocks() - shares + k);
    }
    void call_all() const {
        for (Index block = 0; block < blocks(); ++block) {
            call(block);
        }
    }

  private:
    [[nodiscard]] std::int64_t before(Index block) const { return work_before[static_cast<std::size_t>(block)]; }
};

/// The first block that threw, and its exception. An exception may not leave the loop before all threads have.
struct Failure {
    Index block = std::numeric_limits<Index>::max();
    std::exception_ptr what;

    void call(const Loop& loop, Index number) {
        try {
            loop.call(number);
        } catch (...) {
            add({number, std::current_exception()});
        }
    }
    void add(const Failure& other) {
        if (other.block < block) {
            *this = other;
        }
    }
};

}  // namespace

/// The calling thread, and what it has done of its loop so far.
struct ThreadTeam::Caller {
    Loop loop;
    Clock::time_point now = Clock::now();  ///< last time that it read the clock
    const Clock::time_point began = now;
    double work = 0.0;      ///< work of the blocks that it has computed
    Nanoseconds worked{0};  ///< time that these took
    Nanoseconds waited{0};  ///< time that it has waited for workers
    Failure failure{};      ///< of all blocks done so far

    void compute(Index block) {
        failure.call(loop, block);
        work += loop.work(block, block + 1);
    }
    /// Time since the last reading of the clock.
    Nanoseconds lap() {
        const auto before = std::exchange(now, Clock::now());
        return now - before;
    }
};

/// A worker thread, and what it shares with the caller: the number of blocks left to begin (`left_`) and the number
/// that it has computed (`done_`). Both sides take a block by decrementing `left_`, and only a side that has taken one
/// reads `loop_`. The caller writes the next loop when all blocks of the last one are done, so a worker that comes late
/// finds nothing left, or the next loop.
///
/// No wake-up is lost. A side that is about to sleep says so and then checks its condition once more. A side that
/// changes the condition then checks whether the other one sleeps. These operations are sequentially consistent, so at
/// least one side sees the other's change, and the notification waits for `mutex_` until the other side is asleep.
class ThreadTeam::Worker {
  public:
    explicit Worker(int number)
        : thread_([this, number] {
              number_of_this_thread = number;
              work();
          }) {}
    ~Worker() {
        give(end);
        thread_.join();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    [[nodiscard]] bool is_left_out(Clock::time_point now) const { return account_.is_left_out(now); }

    /// Give it blocks [first, last) of a loop. @pre all blocks of the previous loop are done
    void begin(const Loop& loop, Index first, Index last) {
        loop_ = loop;
        last_ = last;
        work_ = loop.work(first, last);
        done_at_end_ = done_.load() + (last - first);
        comes_late_ = !give(last - first);
    }

    /// Compute the blocks that the worker has not begun in time, and wait for those that it has begun.
    void finish(Caller& caller) {
        waited_ = Nanoseconds{0};
        const auto done = [this] { return done_.load() == done_at_end_; };
        if (!done()) {
            if (!comes_late_) {
                spin_until(done, patience);
                waited_ += caller.lap();
            }
            for (Index block = take(); block >= 0; block = take()) {
                caller.compute(block);
                work_ -= caller.loop.work(block, block + 1);
                --done_at_end_;
            }
            caller.worked += caller.lap();
            if (!spin_until(done, shortest_spin)) {
                std::unique_lock lock(mutex_);
                caller_sleeps_ = true;
                changed_.wait(lock, done);
                caller_sleeps_ = false;
            }
            waited_ += caller.lap();
            caller.waited += waited_;
        }
        if (failure_.what) {
            caller.failure.add(std::exchange(failure_, {}));
        }
    }

    /// Decide whether it takes part in the next loops. Called when all of a loop is done.
    /// @param per_work  time that the caller took for its work
    /// @param lost      time that the caller had no processor because of this worker
    void settle(Nanoseconds per_work, Nanoseconds lost, Clock::time_point now) {
        account_.settle(per_work * work_, waited_ + lost, now);
    }

  private:
    static constexpr Index end = -1;  // takes the place of a number of blocks
    enum class State { awake, asleep, called };

    /// @return whether the worker is awake
    bool give(Index blocks) {
        left_ = blocks;
        const State state = state_;
        if (state == State::asleep) {
            {
                const std::lock_guard lock(mutex_);
                state_ = state_ == State::asleep ? State::called : state_.load();
            }
            changed_.notify_all();
        }
        return state == State::awake;
    }

    /// @return number of a block that now belongs to this side; negative if none is left
    Index take() {
        Index left = left_;
        while (left > 0) {
            if (left_.compare_exchange_weak(left, left - 1)) {
                return last_ - left;
            }
        }
        return -1;
    }

    void work() {
        while (left_ != end) {
            const auto began = Clock::now();
            Index computed = 0;
            for (Index block = take(); block >= 0; block = take()) {
                failure_.call(loop_, block);
                ++computed;
            }
            if (computed > 0) {
                done_ += computed;
                if (caller_sleeps_) {
                    { const std::lock_guard lock(mutex_); }
                    changed_.notify_all();
                }
            }
            const Clock::duration spin = std::clamp<Clock::duration>(Clock::now() - began, shortest_spin, longest_spin);
            if (!spin_until([this] { return left_ != 0; }, spin)) {
                sleep();
            }
        }
    }

    void sleep() {
        std::unique_lock lock(mutex_);
        state_ = State::asleep;
        changed_.wait(lock, [this] { return left_ != 0 || state_ == State::called; });
        state_ = State::awake;
    }

    static constexpr auto nothing = [](Index, Index) {};

    // Each group has cache lines of its own: what the caller writes for the worker, what the worker writes for the
    // caller, what both mostly only read, and what the caller uses alone.
    alignas(cache_lines) std::atomic<Index> left_ = 0;
    Index last_ = 0;
    Loop loop_{0, 1, nothing, {}};
    alignas(cache_lines) std::atomic<Index> done_ = 0;
    Failure failure_;
    alignas(cache_lines) std::atomic<State> state_ = State::awake;
    std::atomic<bool> caller_sleeps_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
    alignas(cache_lines) double work_ = 0.0;  // of the blocks of this loop that the worker computes
    Index done_at_end_ = 0;                   // `done_` when it has computed them
    bool comes_late_ = false;
    Nanoseconds waited_{0};
    WorkerAccount account_;
    std::thread thread_;  // last member, because it starts to work when constructed
};

int number_in_team() {
    return number_of_this_thread;
}

ThreadTeam::ThreadTeam(int threads) {
    [[maybe_unused]] static const int registered = pthread_atfork(nullptr, nullptr, [] { ++forks; });
    forks_ = forks;
    account_ = std::make_unique<CallerAccount>();
    try {
        const SignalsBlocked signals_blocked;  // signals that ask the program to stop are for its first thread
        const auto workers = static_cast<std::size_t>(threads - 1);
        workers_.reserve(workers);
        present_.reserve(workers);
        while (workers_.size() < workers) {
            workers_.push_back(std::make_unique<Worker>(static_cast<int>(workers_.size()) + 1));
        }
        return;
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
    throw ThreadsError(fmt::format(
        "{} threads are asked for, and the system allows no more than {} here; ask for fewer "
        "(on the command line --threads, OMP_NUM_THREADS), or see the limits of processes and memory (ulimit -a)",
        threads, workers_.size() + 1));
}

ThreadTeam::~ThreadTeam() {
    if (in_child_process()) {
        for (auto& worker : workers_) {  // a child process has no such thread to join
            static_cast<void>(worker.release());
        }
    }
}

bool ThreadTeam::in_child_process() const {
    return forks_ != forks;
}

void ThreadTeam::for_each_block(Index count, Index block_length, BlockFunction function,
                                std::span<const std::int64_t> work_before) {
    const Loop loop{count, block_length, function, work_before};
    const IsCaller is_caller;
    if (workers_.empty() || loop.blocks() < 2 || in_child_process() || at_work_.exchange(true)) {
        loop.call_all();
        return;
    }
    const struct AtWork {
        std::atomic<bool>& flag;
        ~AtWork() { flag = false; }
    } at_work{at_work_};
    Caller caller{loop};
    share_out(caller);
}

void ThreadTeam::share_out(Caller& caller) {
    const Index blocks = caller.loop.blocks();
    present_.clear();
    for (auto& worker : workers_) {
        if (static_cast<Index>(present_.size()) + 1 < blocks && !worker->is_left_out(caller.now)) {
            present_.push_back(worker.get());
        }
    }
    if (present_.empty()) {
        caller.loop.call_all();
        static_cast<void>(account_->settle(caller.began, Clock::now(), true, Nanoseconds{0}, processor_time));
        return;
    }
    const Index sharers = static_cast<Index>(present_.size()) + 1;
    const auto share_begin = [&](Index k) { return caller.loop.share_begin(k, sharers); };
    for (Index k = 1; k < sharers; ++k) {
        present_[static_cast<std::size_t>(k - 1)]->begin(caller.loop, share_begin(k), share_begin(k + 1));
    }
    for (Index block = 0; block < share_begin(1); ++block) {
        caller.compute(block);
    }
    caller.worked = caller.lap();
    for (Worker* worker : present_) {
        worker->finish(caller);
    }
    const auto lost = account_->settle(caller.began, caller.now, false, caller.waited, processor_time);
    if (caller.worked > CallerAccount::interval) {
        caller.worked -= std::min(caller.worked, lost.all);
    }
    for (Worker* worker : present_) {
        // The loss does not show which worker took the caller's processor, so the last one is charged for it. If the
        // caller still loses time with one worker fewer, the next one is left out.
        worker->settle(caller.worked / std::max(caller.work, 1.0),
                       worker == present_.back() ? lost.by_team : Nanoseconds{0}, caller.now);
    }
    if (caller.failure.what) {
        std::rethrow_exception(caller.failure.what);
    }
}

}  // namespace ljmd
