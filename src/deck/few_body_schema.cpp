#include "ljmd/core/registry.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

namespace {

constexpr double largest_coordinate = 1e100;  // its square and cube are finite
constexpr double largest_mass = 1e100;

Schema force_schema() {
    std::map<std::string, std::vector<Key>> methods;
    std::string meaning = "what moves the bodies";
    for (const auto& method : all_few_body_forces()) {
        methods[method.name] = keys_of(method);
        meaning += "; " + method.name + ": " + method.meaning;
    }
    Schema schema("[force]", {Key::choice("type", plugin_names(all_few_body_forces())).meaning(meaning)});
    return schema.select("type", methods);
}

Schema body_schema() {
    const auto components = [](const char* name) {
        return Key::vector(name).at_least(-largest_coordinate).at_most(largest_coordinate);
    };
    return Schema("[[body]]",
                  {Key::number("mass").above(0.0).at_most(largest_mass).meaning("mass of the body"),
                   components("position")
                       .meaning("where it starts; one, two or three components, as many for all bodies. An angle or a "
                                "distance where the force has such a coordinate"),
                   components("velocity").meaning("its velocity there")});
}

Schema few_body_stage_schema() {
    return stage_schema(DeckKind::few_body, Key::number("time_step").above(0.0).meaning("in the deck's unit of time"))
        .with({Key::flag("sample").defaults_to(true).meaning("the analyses look at this stage; sampled stages "
                                                             "follow one another, and none runs backwards")});
}

Schema few_body_output_schema() {
    const Schema thermo("thermo",
                        {Key::integer("every")
                             .at_least(1)
                             .defaults_to(std::int64_t{1})
                             .meaning("steps between rows of thermo.csv, from which the largest deviations in "
                                      "the results are taken; the end has a row, too")});
    const Schema trajectory(
        "trajectory",
        {Key::choice("format", {"csv", "h5md", "xyz"})
             .defaults_to("csv")
             .meaning("trajectory.csv (positions and velocities), trajectory.h5md (H5MD 1.1) or trajectory.xyz "
                      "(extended XYZ)"),
         Key::integer("every").at_least(1).meaning("steps between frames"),
         Key::flag("velocities")
             .defaults_to(false)
             .meaning("write velocities to h5md and xyz too; csv always has them"),
         Key::flag("accelerations").defaults_to(false).meaning("write accelerations too; csv only")});
    return output_schema(thermo, trajectory, "every step");
}

Schema few_body_analysis_schema() {
    Schema schema("[analysis]");
    for (const auto& method : all_few_body_analyses()) {
        schema = schema.with({Key::table(method.name, Schema(method.name, keys_of(method)))
                                  .optional("not measured")
                                  .meaning(method.meaning)});
    }
    return schema;
}

}  // namespace

Schema few_body_schema() {
    return Schema("the deck",
                  {Key::text("title").defaults_to("").meaning("one line about the run"),
                   Key::table("force", force_schema()).meaning("the law of motion"),
                   Key::tables("body", body_schema())
                       .meaning("the bodies, counted from 1; `--set body.2.mass=0.5` changes the second"),
                   Key::tables("stage", few_body_stage_schema()).meaning("what is done, one stage after the other"),
                   Key::table("output", few_body_output_schema()).optional("all defaults").meaning("files"),
                   Key::table("analysis", few_body_analysis_schema())
                       .optional("none")
                       .meaning("measured at every step of the sampled stages")});
}

}  // namespace ljmd
