#pragma once

#include <optional>
#include <string>

#include "ljmd/detail/deck/run_files.hpp"
#include "options/placed.hpp"

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

/// `trajectory` in [output].
struct FluidTrajectory : TrajectoryOutput {
    void describe(Description& description);
};
struct FewBodyTrajectory : TrajectoryOutput {
    FewBodyTrajectory() { format = "csv"; }
    void describe(Description& description);
};

/// [output].
template <class Thermo, class Trajectory>
struct OutputTable {
    std::optional<std::string> directory;
    Placed<Thermo> thermo;
    std::optional<Placed<Trajectory>> trajectory;
    Placed<CheckpointOutput> checkpoint;
    bool report = false;  ///< whether the command ends with a page about the run

    void describe(TableDescription& description);
};

using FluidOutputTable = OutputTable<FluidThermo, FluidTrajectory>;
using FewBodyOutputTable = OutputTable<FewBodyThermo, FewBodyTrajectory>;

extern template struct OutputTable<FluidThermo, FluidTrajectory>;
extern template struct OutputTable<FewBodyThermo, FewBodyTrajectory>;

}  // namespace ljmd
