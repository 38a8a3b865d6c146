#pragma once

#include <optional>
#include <string>

#include "ljmd/input/placed.hpp"

namespace ljmd {

/// `thermo` in [output]: when energies and temperatures are written.
struct FluidThermo {
    Index every;  ///< [steps]

    FluidThermo();
    void describe(Description& description);
};
struct FewBodyThermo {
    Index every = 1;  ///< [steps]

    void describe(Description& description);
};

/// `trajectory` in [output]: when and how a trajectory is written.
struct TrajectoryOutput {
    std::string format;  ///< "h5md", "xyz" or, for few-body systems, "csv"
    Index every = 1;     ///< [steps]
    bool velocities = false;
    bool accelerations = false;  ///< csv only
    std::string units = "reduced";

    [[nodiscard]] bool si() const { return units == "si"; }
};
struct FluidTrajectory : TrajectoryOutput {
    FluidTrajectory() { format = "h5md"; }
    void describe(Description& description);
};
struct FewBodyTrajectory : TrajectoryOutput {
    FewBodyTrajectory() { format = "csv"; }
    void describe(Description& description);
};

/// `checkpoint` in [output]: when checkpoints are written, in addition to those at the start, at the ends of stages,
/// and when a run is stopped.
struct CheckpointOutput {
    Interval every = {.seconds = 300.0};
    Index keep = 2;  ///< generations

    void describe(Description& description);
};

/// [output].
template <class Thermo, class Trajectory>
struct OutputTable {
    std::optional<std::string> directory;
    Placed<Thermo> thermo;
    std::optional<Placed<Trajectory>> trajectory;
    Placed<CheckpointOutput> checkpoint;

    void describe(TableDescription& description);
};

using FluidOutputTable = OutputTable<FluidThermo, FluidTrajectory>;
using FewBodyOutputTable = OutputTable<FewBodyThermo, FewBodyTrajectory>;

extern template struct OutputTable<FluidThermo, FluidTrajectory>;
extern template struct OutputTable<FewBodyThermo, FewBodyTrajectory>;

}  // namespace ljmd
