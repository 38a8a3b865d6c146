#pragma once

#include <algorithm>
#include <chrono>

namespace ljmd {

/// What a thread that helps with loops has saved and cost whoever called them, and whether it is better left out.
///
/// After each loop the time that its blocks saved the caller is added and the time that the caller waited for it is
/// taken off. What was gained does not count against a later loss. A helper that has lost more than largest_loss,
/// because another program has its processor or because the loops are too small, is on leave for leave_per_loss times
/// the loss. So the caller loses at most about a tenth of its time, however bad the helper is.
class WorkerAccount {
  public:
    using Clock = std::chrono::steady_clock;
    using Nanoseconds = std::chrono::duration<double, std::nano>;

    /// More than an interrupt costs now and then.
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
