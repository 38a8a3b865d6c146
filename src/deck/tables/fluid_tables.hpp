#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/tables/output_table.hpp"
#include "engine/tables/potential_table.hpp"
#include "engine/tables/system_table.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "options/placed.hpp"

namespace ljmd {

/// [performance]: how forces are computed.
struct PerformanceTable {
    std::string precision = "double";

    void describe(Description& description);
};

/// [analysis] of a fluid.
struct FluidAnalysisTable {
    std::vector<Choice> asked;

    void describe(TableDescription& description);
};

/// The deck of a fluid.
struct FluidTables {
    std::string title;
    std::string units = "reduced";
    std::optional<Placed<ArgonTable>> argon;
    Placed<SystemTable> system;
    Placed<PotentialTable> potential;
    Placed<NeighborSpec> neighbors;
    Placed<PerformanceTable> performance;
    std::vector<Placed<Stage>> stages;
    Placed<FluidOutputTable> output;
    Placed<FluidAnalysisTable> analysis;

    void describe(TableDescription& description);
};

}  // namespace ljmd
