#include "ljmd/deck/tables/few_body_tables.hpp"

#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

namespace {

constexpr double largest_coordinate = 1e100;  // its square and cube are finite
constexpr double largest_mass = 1e100;

Key& describe_vector(Description& description, const std::string& name, std::vector<double>& components) {
    return description.required_vector(name, components).at_least(-largest_coordinate).at_most(largest_coordinate);
}

}  // namespace

void ForceTable::describe(TableDescription& description) {
    const std::vector<FewBodyForceMethod> forces = all_few_body_forces();
    description.plugin("type", forces, method).meaning("what moves the bodies; " + meanings_of(forces));
}

void BodyTable::describe(Description& description) {
    description.required_number("mass", mass).above(0.0).at_most(largest_mass).meaning("mass of the body");
    describe_vector(description, "position", position)
        .meaning(
            "where it starts; one, two or three components, as many for all bodies. An angle or a distance where the "
            "force has such a coordinate");
    describe_vector(description, "velocity", velocity).meaning("its velocity there");
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
