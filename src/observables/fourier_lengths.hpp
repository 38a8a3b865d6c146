#pragma once

#include "ljmd/core/types.hpp"

namespace ljmd {

/// The length of a transform of real numbers. @throws ContractViolation unless it is even and positive, and an int
[[nodiscard]] int even_length(Index n);

/// The length of a transform that needs so many. @throws ContractViolation when it is less, or no int
[[nodiscard]] int at_least(Index least, Index n);

}  // namespace ljmd
