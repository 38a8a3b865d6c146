#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ljmd {

/// While an object of this type lives, the floating-point arithmetic of its thread treats subnormal numbers (below
/// 2^-126 = 1.2e-38 in single precision, 2^-1022 in double) as zero, as operands and as results.
///
/// On Intel's processors each instruction that meets a subnormal number takes some 150 cycles, and sums over vectors of
/// pairs meet many: r^-12 of pairs far out of range. Without effect on processors other than x86-64 and ARM64.
class FlushSubnormals {
  public:
    FlushSubnormals(const FlushSubnormals&) = delete;
    FlushSubnormals& operator=(const FlushSubnormals&) = delete;

#if defined(__x86_64__)
    FlushSubnormals() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | denormals_are_zero);
    }
    ~FlushSubnormals() {
        _mm_setcsr(before_);
    }

  private:
    static constexpr unsigned denormals_are_zero = 0x0040;
    unsigned before_;  ///< control and status register; exception flags set in between are dropped
#elif defined(__aarch64__)
    FlushSubnormals() : before_(control()) {
        set_control(before_ | flush_to_zero);
    }
    ~FlushSubnormals() {
        set_control(before_);
    }

  private:
    static constexpr unsigned long flush_to_zero = 1UL << 24U;
    static unsigned long control() {
        unsigned long value = 0;
        __asm__ volatile("mrs %0, fpcr" : "=r"(value));
        return value;
    }
    static void set_control(unsigned long value) {
        __asm__ volatile("msr fpcr, %0" : : "r"(value));
    }

    unsigned long before_;  ///< floating-point control register
#else
    FlushSubnormals() {}
    ~FlushSubnormals() {}
#endif
};

}  // namespace ljmd
