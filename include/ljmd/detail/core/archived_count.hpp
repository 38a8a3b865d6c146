#pragma once

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Check a count read from an archive. Counts that pass are exact as doubles, and incrementing them cannot overflow in
/// any run. @throws CheckpointError
inline void require_count(Index count) {
    constexpr Index most = Index{1} << 53;
    if (count < 0 || count > most) {
        throw CheckpointError("a count is negative or too large");
    }
}

}  // namespace ljmd
