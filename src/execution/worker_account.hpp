#pragma once

#include <algorithm>
#include <chrono>

namespace ljmd {

/// Account of what a worker has saved and cost the caller; decides whether to leave it out.
///
/// After each loop the time that the worker's blocks saved the caller is added, and the time that the caller waited for
/// it is subtracted. Gains do not offset later losses. A worker whose loss exceeds largest_loss, because another
/// program has its processor or because the loops are too small, is on leave for leave_per_loss times the loss; twice,
/// four times, ... longest_leave_per_loss times if it comes to the next loss sooner than the leave before it lasted. So
/// the caller loses at most about a tenth of its time, however slow the worker is, and less if it stays so.
class WorkerAccount {
  public:
    using Clock = std::chrono::steady_clock;
    using Nanoseconds = std::chrono::duration<double, std::nano>;

    /// More than an occasional interrupt costs.
    static constexpr Nanoseconds largest_loss{50e3};
    static constexpr double leave_per_loss = 10.0;
    static constexpr double longest_leave_per_loss = 80.0;

    [[nodiscard]] bool on_leave(Clock::time_point now) const { return now < back_at_; }

    void settle(Nanoseconds saved, Nanoseconds waited, Clock::time_point now) {
        balance_ = std::min(Nanoseconds{0}, balance_ + saved - waited);
        if (balance_ < -largest_loss) {
            const bool soon = now < back_at_ + leave_;
            per_loss_ = soon ? std::min(2.0 * per_loss_, longest_leave_per_loss) : leave_per_loss;
            leave_ = std::chrono::duration_cast<Clock::duration>(-per_loss_ * balance_);
            back_at_ = now + leave_;
            balance_ = Nanoseconds{0};
        }
    }

  private:
    Nanoseconds balance_{0};
    Clock::time_point back_at_{};
    Clock::duration leave_{0};  ///< length of the last one
    double per_loss_ = leave_per_loss;
};

}  // namespace ljmd
