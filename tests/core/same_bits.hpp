#pragma once

#include <stdexcept>
#include <string>

#include "core/environment_guard.hpp"
#include "ljmd/execution/simd.hpp"

namespace ljmd::test {

/// Until the end of the scope kernels are those that every processor can run, so that a chaotic trajectory is the same
/// one everywhere: for tests that judge by statistics. ctest takes care of the mathematical library (same_bits.env).
class SameBits {
  public:
    SameBits() : simd_("LJMD_SIMD", std::string(name(SimdLevel::portable))) {
        if (default_simd_level() != SimdLevel::portable) {
            throw std::logic_error("this process has set another SIMD level");
        }
    }

  private:
    EnvironmentGuard simd_;
};

}  // namespace ljmd::test
