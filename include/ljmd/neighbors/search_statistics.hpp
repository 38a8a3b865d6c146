#pragma once

#include "ljmd/core/archive.hpp"
#include "ljmd/core/archived_count.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// What a pair search did since it was made.
struct SearchStatistics {
    Index preparations = 0;        ///< calls of prepare()
    Index rebuilds = 0;            ///< how many of them built cells or lists anew
    Index late_rebuilds = 0;       ///< of those: too late, pairs within the cutoff may have been missed
    Index distance_tests = 0;      ///< pairs looked at while building lists (Verlet list only)
    double seconds_sorting = 0.0;  ///< atoms put in order, ghosts made anew
    double seconds_listing = 0.0;  ///< lists checked and built, ghosts moved

    void archive(Archive& a) {
        a(preparations, rebuilds, late_rebuilds, distance_tests, seconds_sorting, seconds_listing);
        for (const Index count : {preparations, rebuilds, late_rebuilds, distance_tests}) {
            require_count(count);
        }
    }
};

}  // namespace ljmd
