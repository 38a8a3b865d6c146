#pragma once

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// Wall time of a time loop by phase [s].
struct PhaseSeconds {
    double force = 0.0;      ///< pair sums
    double list = 0.0;       ///< neighbour lists: checks and building
    double sort = 0.0;       ///< atoms sorted in space, ghosts made
    double integrate = 0.0;  ///< rest of the steps
    double observe = 0.0;    ///< measuring, watching and reporting
    double write = 0.0;      ///< thermo.csv and trajectory
    [[nodiscard]] double sum() const { return force + list + sort + integrate + observe + write; }

    void archive(Archive& a) { a(force, list, sort, integrate, observe, write); }
};

/// {"force": .., "list": .., ...}
[[nodiscard]] Data phases_data(const PhaseSeconds& seconds);

}  // namespace ljmd
