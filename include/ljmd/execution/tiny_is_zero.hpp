#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ljmd {

/// While one lives, the floating-point arithmetic of its thread takes numbers below the normal range (2^-126 = 1.2e-38
/// in single precision, 2^-1022 in double) for zero, as operands and as results.
///
/// Intel's processors spend some 150 cycles on each instruction that meets such a number, and a sum over vectors of
/// pairs meets many: r^-12 of what is far out of reach is one. On other processors than x86-64 nothing changes.
class TinyIsZero {
  public:
    TinyIsZero(const TinyIsZero&) = delete;
    TinyIsZero& operator=(const TinyIsZero&) = delete;

#if defined(__x86_64__)
    TinyIsZero() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | denormals_are_zero);
    }
    ~TinyIsZero() {
        _mm_setcsr(before_);
    }

  private:
    static constexpr unsigned denormals_are_zero = 0x0040;
    unsigned before_;  ///< control and status word; what was flagged meanwhile is dropped
#else
    TinyIsZero() {}
    ~TinyIsZero() {}
#endif
};

}  // namespace ljmd
