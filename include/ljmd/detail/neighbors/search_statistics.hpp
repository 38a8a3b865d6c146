#pragma once

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/core/archived_count.hpp"

namespace ljmd {

/// What a pair search has done since it was made.
struct SearchStatistics {
    Index preparations = 0;        ///< calls of prepare()
    Index rebuilds = 0;            ///< of these, calls that rebuilt cells or lists
    Index late_rebuilds = 0;       ///< of these, too late: pairs within the cutoff may have been missed
    Index distance_tests = 0;      ///< pairs tested while building lists (Verlet list only)
    double seconds_sorting = 0.0;  ///< sorting atoms and making ghosts, with the check of the list before that
    double seconds_listing = 0.0;  ///< checking lists that are still valid, and building lists

    void archive(Archive& a) {
        a(preparations, rebuilds, late_rebuilds, distance_tests, seconds_sorting, seconds_listing);
        for (const Index count : {preparations, rebuilds, late_rebuilds, distance_tests}) {
            require_count(count);
        }
    }
};

}  // namespace ljmd
