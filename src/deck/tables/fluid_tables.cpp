#include "deck/tables/fluid_tables.hpp"

#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

void PerformanceTable::describe(Description& description) {
    description.choice("precision", {"double", "mixed"}, precision)
        .meaning(
            "of pair terms; mixed: in single precision from exact differences of positions, summed in double; "
            "verlet-list only");
}

void FluidAnalysisTable::describe(TableDescription& description) {
    description.choices(all_analyses(), "not measured", asked);
}

void FluidTables::describe(TableDescription& description) {
    description.text("title", title).meaning("one line about the run");
    description.choice("units", {"reduced"}, units)
        .meaning(
            "sigma = epsilon = m = k_B = 1, time in tau = sqrt(m sigma^2/epsilon); with [argon] a quantity may also be "
            "a string with a unit, \"86.5 K\"");
    description.table("argon", "[argon]", argon)
        .optional("reduced units only")
        .meaning("a real substance: adds SI units to the deck and SI columns to the results");
    description.table("system", "[system]", system).meaning("atoms and box");
    description.table("potential", "[potential]", potential).meaning("forces");
    description.table("neighbors", "[neighbors]", neighbors).optional("all defaults").meaning("pair search");
    description.table("performance", "[performance]", performance)
        .optional("all defaults")
        .meaning("how forces are computed");
    description.tables("stage", "[[stage]]", stages).meaning("what is done, one stage after the other");
    description.table("output", "[output]", output).optional("all defaults").meaning("files");
    description.table("analysis", "[analysis]", analysis).optional("none").meaning("measured in the sampled stages");
}

}  // namespace ljmd
