#pragma once

#include <string>
#include <vector>

#include "deck/tables/output_table.hpp"
#include "ljmd/detail/engine/few_body_spec.hpp"
#include "options/placed.hpp"

namespace ljmd {

/// [force]: the law of motion.
struct ForceTable {
    Choice method = {};

    void describe(TableDescription& description);
};

/// [[stage]] of a few-body deck.
struct FewBodyStage : Stage {
    FewBodyStage() { sample = true; }

    void describe(TableDescription& description) { describe_few_body(description); }
};

/// [analysis] of a few-body deck.
struct FewBodyAnalysisTable {
    std::vector<Choice> asked;

    void describe(TableDescription& description);
};

/// A few-body deck.
struct FewBodyTables {
    std::string title;
    Placed<ForceTable> force;
    std::vector<Placed<BodyStart>> bodies;
    std::vector<Placed<FewBodyStage>> stages;
    Placed<FewBodyOutputTable> output;
    Placed<FewBodyAnalysisTable> analysis;

    void describe(TableDescription& description);
};

}  // namespace ljmd
