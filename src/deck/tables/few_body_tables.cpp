#include "deck/tables/few_body_tables.hpp"

#include "forces/few_body_force.hpp"
#include "observables/few_body/few_body_analysis.hpp"

namespace ljmd {

void ForceTable::describe(TableDescription& description) {
    const std::vector<FewBodyForceMethod> forces = all_few_body_forces();
    description.plugin("type", forces, method).meaning("what moves the bodies; " + meanings_of(forces));
}

void FewBodyAnalysisTable::describe(TableDescription& description) {
    description.choices(all_few_body_analyses(), "not measured", asked);
}

void FewBodyTables::describe(TableDescription& description) {
    description.text("title", title).meaning("one line about the run");
    description.table("force", "[force]", force).meaning("the law of motion");
    description.tables("body", "[[body]]", bodies)
        .meaning("the bodies, counted from 1; `--set body.2.mass=0.5` changes the second");
    description.tables("stage", "[[stage]]", stages).meaning("what is done, one stage after the other");
    description.table("output", "[output]", output).optional("all defaults").meaning("files");
    description.table("analysis", "[analysis]", analysis)
        .optional("none")
        .meaning("measured at every step of the sampled stages");
}

}  // namespace ljmd
