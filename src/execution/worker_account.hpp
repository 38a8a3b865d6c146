#pragma once

#include <algorithm>
#include <chrono>

namespace ljmd {

/// Account of what a worker has saved and cost the caller; decides whether to leave it out.
///
/// After each loop the time that the worker's blocks saved the caller is added, and the time that the caller waited for
/// it is subtracted. Gains offset later losses up to most_credit: what the system takes from a worker now and then is
/// far less than the worker saves between. A worker whose loss exceeds largest_loss, because another program has its
/// processor or because the loops are too small, is left out for pause_per_loss times the loss. The
/// pause is twice as long, four times, ... up to longest_pause_per_loss times the loss, if the next loss comes within
/// the length of the last pause after its end. So the caller loses at most about a tenth of its time, however slow the
/// worker is, and less if the worker stays slow.
class WorkerAccount {
  public:
    using Clock = std::chrono::steady_clock;
    using Nanoseconds = std::chrono::duration<double, std::nano>;

    /// More than an occasional interrupt costs.
    static constexpr Nanoseconds largest_loss{50e3};
    /// More than an interruption by the system or by another guest of the machine usually takes, and less than the few
    /// milliseconds that another program has the processor at a time.
    static constexpr Nanoseconds most_credit{1e6};
    static constexpr double pause_per_loss = 10.0;
    static constexpr double longest_pause_per_loss = 80.0;

    [[nodiscard]] bool is_left_out(Clock::time_point now) const { return now < back_at_; }

    void settle(Nanoseconds saved, Nanoseconds waited, Clock::time_point now) {
        balance_ = std::min(most_credit, balance_ + saved - waited);
        if (balance_ < -largest_loss) {
            const bool soon = now < back_at_ + pause_;
            per_loss_ = soon ? std::min(2.0 * per_loss_, longest_pause_per_loss) : pause_per_loss;
            pause_ = std::chrono::duration_cast<Clock::duration>(-per_loss_ * balance_);
            back_at_ = now + pause_;
            balance_ = Nanoseconds{0};
        }
    }

  private:
    Nanoseconds balance_{0};
    Clock::time_point back_at_{};
    Clock::duration pause_{0};  ///< length of the last one
    double per_loss_ = pause_per_loss;
};

}  // namespace ljmd
