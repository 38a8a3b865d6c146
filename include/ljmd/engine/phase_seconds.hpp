#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ljmd/core/archive.hpp"

namespace ljmd {

/// Where the wall time of a time loop went [s].
struct PhaseSeconds {
    double force = 0.0;      ///< sums over pairs
    double list = 0.0;       ///< neighbour lists checked and built, ghosts moved
    double sort = 0.0;       ///< atoms sorted in space, ghosts made
    double integrate = 0.0;  ///< the rest of the steps
    double observe = 0.0;    ///< everything measured, watched and told on the way
    double write = 0.0;      ///< thermo.csv and trajectory
    [[nodiscard]] double sum() const { return force + list + sort + integrate + observe + write; }

    void archive(Archive& a) { a(force, list, sort, integrate, observe, write); }
};

/// {"force": .., "list": .., ...}
[[nodiscard]] nlohmann::ordered_json phases_json(const PhaseSeconds& seconds);

}  // namespace ljmd
