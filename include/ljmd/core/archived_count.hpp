#pragma once

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Refuse what an archive gave for a number of things, and is none: one can be added to a number that passes, for
/// longer than any run lasts, and it is exact as a double. @throws CheckpointError
inline void require_count(Index count) {
    constexpr Index most = Index{1} << 53;
    if (count < 0 || count > most) {
        throw CheckpointError("a number of things cannot be one");
    }
}

}  // namespace ljmd
