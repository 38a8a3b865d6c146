#pragma once

#include <chrono>

namespace ljmd {

/// Tell the processor that this thread is waiting, so that another thread on the same core runs faster.
inline void pause_processor() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ __volatile__("yield");
#endif
}

/// Spin until a condition holds, for a limited time. @return whether it holds
template <class Condition>
bool spin_until(Condition&& condition, std::chrono::steady_clock::duration longest) {
    constexpr int looks = 16;  // take at least as long as reading the clock
    const auto look = [&] {
        for (int k = 0; k < looks; ++k) {
            if (condition()) {
                return true;
            }
            pause_processor();
        }
        return false;
    };
    if (look()) {
        return true;
    }
    for (const auto end = std::chrono::steady_clock::now() + longest; std::chrono::steady_clock::now() < end;) {
        if (look()) {
            return true;
        }
    }
    return condition();
}

}  // namespace ljmd
