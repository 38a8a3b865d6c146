#include "run/spec_plan.hpp"

#include <fmt/format.h>

#include <limits>

#include "core/text.hpp"
#include "deck/deck_schema.hpp"
#include "deck/deck_sense.hpp"
#include "deck/fluid.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "ljmd/core/errors.hpp"
#include "options/toml_writer.hpp"

namespace ljmd {

namespace {

/// Why no deck says the same, whatever stands in for what the program gives; empty if one can.
std::string not_for_decks(const FluidSpec& spec) {
    if (spec.seed > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
        return fmt::format("seed: a deck has one below 2^63, found {}", spec.seed);
    }
    for (const Stage& stage : spec.stages) {
        if (stage.seed != 0 && stage.seed != spec.seed) {
            return fmt::format("stage '{}': in a deck all stages have the seed of the start", stage.name);
        }
    }
    return {};
}

template <class Options>
Placed<Options> without_places(const Options& options) {
    Placed<Options> placed;
    static_cast<Options&>(placed) = options;
    return placed;
}

/// @pre the potential is none of the program's own
FluidTables tables_of(const FluidSpec& spec, const RunFiles& files, Precision precision,
                      const std::filesystem::path& start) {
    const Interval& every = files.checkpoint.every;
    if (every.steps.has_value() == every.seconds.has_value()) {
        throw InputError("checkpoint: 'every' is a number of steps or of seconds, one of both");
    }
    FluidTables tables;
    tables.title = files.title;
    if (spec.units) {
        tables.argon = without_places(ArgonTable{spec.units->si(Dimension::length), spec.units->si(Dimension::energy),
                                                 spec.units->si(Dimension::mass)});
    }
    tables.system = without_places(system_table(spec, start.string()));
    tables.potential = without_places(potential_table(spec));
    tables.neighbors = without_places(spec.neighbors);
    tables.performance = without_places(PerformanceTable{std::string(name(precision))});
    for (const Stage& stage : spec.stages) {
        tables.stages.push_back(without_places(completed(stage)));
    }
    tables.output.thermo.every = spec.sample_every;
    if (files.trajectory) {
        tables.output.trajectory = without_places(FluidTrajectory{*files.trajectory});
    }
    tables.output.checkpoint = without_places(files.checkpoint);
    tables.analysis.asked = spec.analyses;
    return tables;
}

/// The tables as a deck has them: in range, in its order, and with what it leaves out.
Placed<FluidTables> checked(const Table& table, bool has_units) {
    const Location nowhere{std::make_shared<const Source>(Source{"(a FluidSpec)", ""})};
    Diagnostics diagnostics;
    const Placed<FluidTables> tables(validate(table, nowhere, deck_schema(DeckKind::fluid), std::nullopt, diagnostics));
    check_sense(tables, has_units, true, diagnostics);
    if (diagnostics.has_errors()) {
        throw InputError(diagnostics.errors_without_places());
    }
    return tables;
}

}  // namespace

RunPlan plan_of(const FluidSpec& spec, const RunFiles& files, Precision precision, const std::filesystem::path& start) {
    require_no_mistakes(spec, precision);
    if (const std::string why = not_for_decks(spec); !why.empty()) {
        throw InputError(why);
    }
    RunPlan plan{{files}, "(a FluidSpec)", "", {}, {}, precision};
    FluidSpec said = spec;
    if (spec.potential.is_custom()) {
        plan.source = fmt::format(
            "# The pair potential is {}, a formula of a program in C++: that in [potential] stands in for it.\n",
            in_quotes(spec.potential.formula()));
        said.potential = PairPotential::lennard_jones(spec.potential.truncation(), spec.potential.cutoff());
    }
    const Table table = table_of(tables_of(said, files, precision, start));
    // What is run is what the deck says, so that a resumed run, which begins with the deck, goes on with the same.
    FluidSpec& planned = plan.spec.emplace<FluidSpec>(spec_of(checked(table, spec.units.has_value()), spec.units));
    planned.start = spec.start;
    plan.source += toml_document(table);
    return plan;
}

}  // namespace ljmd
