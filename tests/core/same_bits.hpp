#pragma once

#include <string>

#include "core/environment_guard.hpp"
#include "ljmd/execution/simd.hpp"

namespace ljmd::test {

/// Whatever takes the default SIMD level until the end of the scope has kernels that every processor can run, so that a
/// chaotic trajectory is the same one everywhere: for tests that judge by statistics. ctest takes care of the
/// mathematical library (same_bits.env).
class SameBits {
  public:
    SameBits() : simd_("LJMD_SIMD", std::string(name(SimdLevel::portable))) {}

  private:
    EnvironmentGuard simd_;
};

}  // namespace ljmd::test
