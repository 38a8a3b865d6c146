#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

namespace ljmd {

/// Account of the time in which the caller of a team's loops was ready to run, but had no processor.
///
/// Where other programs are busy, a worker that computes or spins may take its own caller's processor, for milliseconds
/// at a time. Only the processor time of the caller's thread shows that. It is read once per `interval` of loops that
/// follow each other closely, because reading it is a system call.
class CallerAccount {
  public:
    using Clock = std::chrono::steady_clock;
    using Nanoseconds = std::chrono::duration<double, std::nano>;

    static constexpr Nanoseconds interval{200e3};
    /// Between loops that are further apart the caller may have slept, which is no loss.
    static constexpr Nanoseconds longest_gap{50e3};

    struct Loss {
        Nanoseconds all{0};      ///< time without processor since the last reading, waiting for workers excepted
        Nanoseconds by_team{0};  ///< the part of it above the caller's loss in loops without workers
    };

    /// Account for a loop.
    /// @param began, ended     when it did
    /// @param alone            it was computed without workers
    /// @param waited           time that the caller waited for workers
    /// @param processor_time   Nanoseconds processor_time(): of the calling thread until now
    /// @return loss of the loops since the last reading; zero if it is not yet time for a reading
    template <class ProcessorTime>
    [[nodiscard]] Loss settle(Clock::time_point began, Clock::time_point ended, bool alone, Nanoseconds waited,
                              ProcessorTime&& processor_time) {
        const bool continues = began - last_end_ <= longest_gap && alone == alone_;
        last_end_ = ended;
        alone_ = alone;
        waited_ += waited;
        const Nanoseconds time = ended - read_at_;
        if (continues && time < interval) {
            return {};
        }
        const Nanoseconds before = std::exchange(processor_time_, processor_time());
        const Nanoseconds lost = std::max(Nanoseconds{0}, time - (processor_time_ - before) - waited_);
        read_at_ = ended;
        waited_ = Nanoseconds{0};
        if (!continues) {
            return {};
        }
        if (!alone) {
            return {lost, std::max(Nanoseconds{0}, lost - lost_alone_ / std::max(time_alone_, interval) * time)};
        }
        if (time_alone_ > memory) {
            time_alone_ /= 2.0;
            lost_alone_ /= 2.0;
        }
        time_alone_ += time;
        lost_alone_ += lost;
        return {lost, Nanoseconds{0}};
    }

  private:
    static constexpr Nanoseconds memory{100e6};  ///< time over which losses without workers are averaged

    Clock::time_point last_end_{};
    Clock::time_point read_at_{};
    Nanoseconds processor_time_{0};
    Nanoseconds waited_{0};  ///< since read_at_
    bool alone_ = false;
    Nanoseconds time_alone_{0};
    Nanoseconds lost_alone_{0};
};

}  // namespace ljmd
