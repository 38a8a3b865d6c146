#pragma once

#include <optional>
#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/options/description.hpp"

namespace ljmd {

/// When and how a trajectory is written.
struct TrajectoryOutput {
    std::string format = "h5md";  ///< one that `ljmd info` names; "csv" for few-body systems alone
    Index every = 100;            ///< [steps]
    bool velocities = false;
    bool forces = false;            ///< fluids only
    bool energies = false;          ///< of the atoms, fluids only
    bool accelerations = false;     ///< csv only
    std::string units = "reduced";  ///< or "si", which takes a substance

    [[nodiscard]] bool si() const { return units == "si"; }
};

/// When checkpoints are written, in addition to those at the start, at the ends of stages, and when a run is stopped.
struct CheckpointOutput {
    Interval every = {.seconds = 300.0};
    Index keep = 2;  ///< generations, 1 to 9

    void describe(Description& description);
};

/// What a run writes into its directory, beside what every run does; docs/files.md describes the files.
struct RunFiles {
    std::string title = {};  ///< one line about the run
    std::optional<TrajectoryOutput> trajectory = {};
    CheckpointOutput checkpoint = {};
};

}  // namespace ljmd
