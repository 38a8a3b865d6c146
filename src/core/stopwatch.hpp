#pragma once

#include <chrono>

namespace ljmd {

/// Measures wall time since its construction or its last reading.
class Stopwatch {
  public:
    /// Time since the last reading [s]; the next reading counts from here.
    double lap() {
        const auto now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

}  // namespace ljmd
