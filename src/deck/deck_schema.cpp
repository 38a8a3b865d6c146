#include "ljmd/deck/deck_schema.hpp"

#include "ljmd/core/registry.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/input/deck_reference.hpp"
#include "ljmd/input/json_schema.hpp"
#include "ljmd/integrators/barostat.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/thermostat.hpp"
#include "ljmd/neighbors/pair_search.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

namespace {

constexpr double min_density = 1e-12;  // one atom in a box of 10^4 sigma
constexpr double min_cutoff = 0.01;    // r^-12 there is 10^24

Schema argon_schema() {
    return Schema(
        "[argon]",
        {Key::quantity("sigma", Dimension::length).above(0.0).meaning("Lennard-Jones length, e.g. \"3.405 angstrom\""),
         Key::quantity("epsilon", Dimension::energy)
             .above(0.0)
             .meaning("Lennard-Jones energy, e.g. \"119.8 K\" (times k_B)"),
         Key::quantity("mass", Dimension::mass).above(0.0).meaning("mass of an atom, e.g. \"39.948 u\"")});
}

Schema lattice_schema() {
    std::vector<std::string> types = lattice_names();
    types.emplace_back(random_lattice);
    return Schema("lattice",
                  {Key::choice("type", types)
                       .meaning("where the atoms start; overlaps of a random start are relaxed before the first step"),
                   Key::integer("cells")
                       .at_least(1)
                       .at_most(1000)
                       .optional("taken from `atoms`")
                       .meaning("cubic cells along each edge: N = 4 cells^3 (fcc) or cells^3 (simple-cubic)"),
                   Key::integer("atoms")
                       .at_least(1)
                       .at_most(1e9)
                       .optional("taken from `cells`")
                       .meaning("number of atoms instead of `cells`; required for random")});
}

Schema system_schema() {
    return Schema(
        "[system]",
        {Key::table("lattice", lattice_schema()).optional("start from `file`").meaning("positions to start from"),
         Key::text("file")
             .optional("start from `lattice`")
             .meaning("file to start from (extended XYZ, H5MD, LAMMPS data or NIST configuration, recognised by "
                      "content), or the directory of a finished run"),
         Key::text("xyz_comment")
             .optional("the comment lines of `file` say all")
             .meaning("keys that the comment lines of an XYZ `file` lack: "
                      "'Lattice=\"20 0 0 0 20 0 0 0 20\" units=si'"),
         Key::number("density")
             .dimension(Dimension::density)
             .unit("sigma^-3")
             .at_least(min_density)
             .optional("that of `file`")
             .meaning("number density N/V; with `file`, box and positions are scaled to it"),
         Key::number("temperature")
             .dimension(Dimension::temperature)
             .unit("epsilon/k_B")
             .at_least(0.0)
             .optional("from the velocities in `file`")
             .meaning("temperature of the start, and of thermostats"),
         Key::choice("velocities", {"maxwell", "file"})
             .optional("file if it has velocities, else maxwell")
             .meaning("draw velocities from Maxwell's distribution, or keep those of `file`"),
         Key::integer("seed")
             .at_least(0)
             .defaults_to(std::int64_t{1})
             .meaning("of all random numbers; a run that goes on from another one's end under a thermostat "
                      "needs another seed")});
}

Schema potential_schema() {
    std::map<std::string, std::vector<Key>> formulas;
    for (const auto& name : PairPotential::formula_names()) {
        formulas[name] = PairPotential::formula_keys(name);
    }
    std::map<std::string, std::vector<Key>> truncations;
    for (const auto& name : PairPotential::truncation_names()) {
        truncations[name] = PairPotential::truncation_keys(name);
    }
    std::string meaning = "pair potential u(r)";
    for (const auto& name : PairPotential::formula_names()) {
        meaning += "; " + name + ": " + PairPotential::formula_meaning(name);
    }
    Schema schema(
        "[potential]",
        {Key::choice("type", PairPotential::formula_names()).meaning(meaning),
         Key::number("cutoff")
             .dimension(Dimension::length)
             .unit("sigma")
             .at_least(min_cutoff)
             .meaning("pairs closer than this interact; at most L/2"),
         Key::choice("truncation", PairPotential::truncation_names()).meaning("what happens at the cutoff"),
         Key::flag("tail")
             .optional("false for the shifted forms; must be given for cut and switched")
             .meaning("correct energy and pressure for what is cut off, with g(r) = 1; cut and switched only")});
    return schema.select("type", formulas).select("truncation", truncations);
}

Schema neighbors_schema() {
    return Schema("[neighbors]",
                  {Key::choice("method", pair_search_names())
                       .defaults_to("verlet-list")
                       .meaning("how pairs are found; all give the same pairs"),
                   Key::number("skin")
                       .dimension(Dimension::length)
                       .unit("sigma")
                       .at_least(0.0)
                       .at_most(max_skin)
                       .defaults_to(0.3)
                       .meaning("the list holds pairs within cutoff + skin, and is rebuilt before any other pair is "
                                "within the cutoff"),
                   Key::integer("every")
                       .at_least(1)
                       .at_most(static_cast<double>(max_steps))
                       .optional("whenever a pair could be missed")
                       .meaning("rebuild the list every so many steps, whatever the atoms do, as other programs may: "
                                "pairs can be missed; verlet-list only")});
}

Schema performance_schema() {
    return Schema("[performance]",
                  {Key::choice("precision", {"double", "mixed"})
                       .defaults_to("double")
                       .meaning("of pair terms; mixed: in single precision from exact differences of positions, summed "
                                "in double; verlet-list only")});
}

/// A table whose `type` selects one of these plug-ins; each has its own keys.
template <class Plugin>
Schema plugin_schema(const std::string& title, const std::vector<Plugin>& plugins) {
    std::map<std::string, std::vector<Key>> keys;
    std::string meaning;
    for (const Plugin& plugin : plugins) {
        keys[plugin.name] = keys_of(plugin);
        meaning += (meaning.empty() ? "" : "; ") + plugin.name + ": " + plugin.meaning;
    }
    return Schema(title, {Key::choice("type", plugin_names(plugins)).meaning(meaning)}).select("type", keys);
}

Schema fluid_stage_schema() {
    return stage_schema(DeckKind::fluid, Key::number("time_step")
                                             .dimension(Dimension::time)
                                             .unit("tau")
                                             .above(0.0)
                                             .meaning("below 0.02 unless --force is given"))
        .with({Key::number("temperature")
                   .dimension(Dimension::temperature)
                   .unit("epsilon/k_B")
                   .at_least(0.0)
                   .optional("that of [system]")
                   .meaning("what the thermostat holds in this stage"),
               Key::table("thermostat", plugin_schema("thermostat", all_thermostats()))
                   .optional("none: constant energy")
                   .meaning("holds the temperature; all but `rescale` go with velocity-verlet"),
               Key::table("barostat", plugin_schema("barostat", all_barostats()))
                   .optional("none: constant volume")
                   .meaning("holds the pressure, beside a canonical thermostat"),
               Key::flag("sample").defaults_to(false).meaning("measure observables in this stage")});
}

Schema fluid_output_schema() {
    Schema thermo(
        "thermo",
        {Key::integer("every")
             .at_least(1)
             .defaults_to(std::int64_t{10})
             .meaning("steps between rows of thermo.csv, which are also the samples that averages are taken over")});
    Schema trajectory("trajectory", {Key::choice("format", {"h5md", "xyz"})
                                         .defaults_to("h5md")
                                         .meaning("trajectory.h5md (H5MD 1.1) or trajectory.xyz (extended XYZ)"),
                                     Key::integer("every").at_least(1).meaning("steps between frames"),
                                     Key::flag("velocities").defaults_to(false).meaning("write velocities too"),
                                     Key::choice("units", {"reduced", "si"})
                                         .defaults_to("reduced")
                                         .meaning("si (nm, ps; angstrom in extended XYZ) needs [argon]")});
    return output_schema(thermo, trajectory, "every 10 steps");
}

Schema fluid_analysis_schema() {
    Schema schema("[analysis]");
    for (const auto& method : all_analyses()) {
        schema = schema.with({Key::table(method.name, Schema(method.name, keys_of(method)))
                                  .optional("not measured")
                                  .meaning(method.meaning)});
    }
    return schema;
}

Schema fluid_schema() {
    return Schema(
        "the deck",
        {Key::text("title").defaults_to("").meaning("one line about the run"),
         Key::choice("units", {"reduced"})
             .defaults_to("reduced")
             .meaning("sigma = epsilon = m = k_B = 1, time in tau = sqrt(m sigma^2/epsilon); with [argon] a quantity "
                      "may also be "
                      "a string with a unit, \"86.5 K\""),
         Key::table("argon", argon_schema())
             .optional("reduced units only")
             .meaning("a real substance: adds SI units to the deck and SI columns to the results"),
         Key::table("system", system_schema()).meaning("atoms and box"),
         Key::table("potential", potential_schema()).meaning("forces"),
         Key::table("neighbors", neighbors_schema()).optional("all defaults").meaning("pair search"),
         Key::table("performance", performance_schema()).optional("all defaults").meaning("how forces are computed"),
         Key::tables("stage", fluid_stage_schema()).meaning("what is done, one stage after the other"),
         Key::table("output", fluid_output_schema()).optional("all defaults").meaning("files"),
         Key::table("analysis", fluid_analysis_schema()).optional("none").meaning("measured in the sampled stages")});
}

}  // namespace

Schema stage_schema(DeckKind kind, const Key& time_step) {
    std::map<std::string, std::vector<Key>> options;
    std::vector<std::string> names;
    std::string integrators = "integration scheme";
    for (const auto& method : all_integrators()) {
        if (method.unbounded_only && kind == DeckKind::fluid) {
            continue;
        }
        integrators += "; " + method.name + ": " + method.meaning;
        options[method.name] = keys_of(method);
        names.push_back(method.name);
    }
    Schema schema("[[stage]]",
                  {Key::text("name").meaning("for messages, results and `--set stage.NAME.key=value`; unique"),
                   Key::choice("integrator", names).defaults_to("velocity-verlet").meaning(integrators), time_step,
                   Key::integer("steps")
                       .at_least(0)
                       .at_most(static_cast<double>(max_steps))
                       .meaning("number of steps; a run of 0 steps in all evaluates the start once"),
                   Key::flag("reverse").defaults_to(false).meaning(
                       "turn the motion round before the first step: a reversible integrator then goes back the way "
                       "it came")});
    return schema.select("integrator", options);
}

Schema output_schema(const Schema& thermo, const Schema& trajectory, const std::string& thermo_default) {
    const Schema checkpoint("checkpoint", {Key::interval("every")
                                               .at_least(1)
                                               .at_most(static_cast<double>(max_steps))
                                               .defaults_to(std::string("5 min"))
                                               .meaning("steps, or wall time"),
                                           Key::integer("keep")
                                               .at_least(1)
                                               .at_most(9)
                                               .defaults_to(std::int64_t{2})
                                               .meaning("generations; with 2, a damaged one can be done without")});
    return Schema(
        "[output]",
        {Key::text("directory").optional("runs/ and the deck's name").meaning("where the results go"),
         Key::table("thermo", thermo).optional(thermo_default).meaning("history of energies, thermo.csv"),
         Key::table("trajectory", trajectory).optional("none").meaning("positions against time"),
         Key::table("checkpoint", checkpoint)
             .optional("every 5 minutes")
             .meaning("what `ljmd resume` goes on from; also written at the start, at the ends of stages, and "
                      "when the run is stopped")});
}

Schema deck_schema(DeckKind kind) {
    return kind == DeckKind::few_body ? few_body_schema() : fluid_schema();
}

std::string deck_reference_page() {
    return "# All keys of a deck\n\n"
           "Made by `ljmd info --keys` from the tables that validate decks. A key without a default must be "
           "given.\n\n`ljmd info --schema` prints the same as a JSON Schema, with which editors complete and check "
           "decks. Taplo, "
           "which VS Code's Even Better TOML uses, takes it from a first line `#:schema ljmd.schema.json` where `ljmd "
           "info "
           "--schema > ljmd.schema.json` has put it.\n\n## A fluid\n\n" +
           schema_markdown(fluid_schema(), 3) +
           "\n## A few bodies\n\nA deck with `[force]` and `[[body]]` tables: no box, no temperature, and whatever "
           "units its numbers are consistent in.\n\n" +
           schema_markdown(few_body_schema(), 3);
}

std::string deck_json_schema() {
    return json_schema("a deck of ljmd", {{"force", "body"}, few_body_schema(), fluid_schema()});
}

}  // namespace ljmd
