#pragma once

#include "ljmd/core/types.hpp"

namespace ljmd {

/// What a pair search did since it was made.
struct SearchStatistics {
    Index preparations = 0;    ///< calls of prepare()
    Index rebuilds = 0;        ///< how many of them built cells or lists anew
    Index distance_tests = 0;  ///< pairs looked at while building lists (Verlet list only)
};

}  // namespace ljmd
