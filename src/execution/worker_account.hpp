#pragma once

#include <algorithm>
#include <chrono>

namespace ljmd {

/// Account of what a worker has saved and cost the caller; decides whether to leave it out.
///
/// After each loop the time that the worker's blocks saved the caller is added, and the time that the caller waited for
/// it is subtracted. Gains do not offset later losses. A worker whose loss exceeds largest_loss, because another
/// program has its processor or because the loops are too small, is on leave for leave_per_loss times the loss. So the
/// caller loses at most about a tenth of its time, however slow the worker is.
class WorkerAccount {
  public:
    using Clock = std::chrono::steady_clock;
    using Nanoseconds = std::chrono::duration<double, std::nano>;

    /// More than an occasional interrupt costs.
    static constexpr Nanoseconds largest_loss{50e3};
    static constexpr double leave_per_loss = 10.0;

    [[nodiscard]] bool on_leave(Clock::time_point now) const { return now < back_at_; }

    void settle(Nanoseconds saved, Nanoseconds waited, Clock::time_point now) {
        balance_ = std::min(Nanoseconds{0}, balance_ + saved - waited);
        if (balance_ < -largest_loss) {
            back_at_ = now - std::chrono::duration_cast<Clock::duration>(leave_per_loss * balance_);
            balance_ = Nanoseconds{0};
        }
    }

  private:
    Nanoseconds balance_{0};
    Clock::time_point back_at_ = Clock::time_point::min();
};

}  // namespace ljmd
