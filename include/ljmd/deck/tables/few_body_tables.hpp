#pragma once

#include <string>
#include <vector>

#include "ljmd/deck/tables/output_table.hpp"
#include "ljmd/deck/tables/stage_table.hpp"
#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/input/placed.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

/// [force]: the law of motion.
struct ForceTable {
    ChosenFewBodyForce method = {};

    void describe(TableDescription& description);
};

/// [[body]].
struct BodyTable {
    double mass = 0.0;
    std::vector<double> position;
    std::vector<double> velocity;

    void describe(Description& description);
};

/// [analysis] of a few-body deck.
struct FewBodyAnalysisTable {
    std::vector<PlacedChoice<FewBodyAnalysisMethod, FewBodyAnalysisOptions>> asked;

    void describe(TableDescription& description);
};

/// A few-body deck.
struct FewBodyTables {
    std::string title;
    Placed<ForceTable> force;
    std::vector<Placed<BodyTable>> bodies;
    std::vector<Placed<FewBodyStageTable>> stages;
    Placed<FewBodyOutputTable> output;
    Placed<FewBodyAnalysisTable> analysis;

    void describe(TableDescription& description);
};

}  // namespace ljmd
