#include "ljmd/run/spec_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/tables/fluid_tables.hpp"
#include "ljmd/options/toml_writer.hpp"

namespace ljmd {

namespace {

std::string lattice_name(Lattice lattice) {
    const std::vector<std::string> names = lattice_names();
    return *std::ranges::find(names, lattice, find_lattice);
}

/// Why no deck says the same; empty if one can.
std::string not_for_decks(const FluidSpec& spec) {
    if (spec.potential.is_custom()) {
        return fmt::format("potential: '{}' is a formula of the program, which no deck can name",
                           spec.potential.formula());
    }
    if (spec.external) {
        return fmt::format("external: '{}' is a force of the program, which no deck can name", spec.external->name());
    }
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

SystemTable system_table(const FluidSpec& spec, const std::filesystem::path& start) {
    SystemTable table;
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        LatticeTable& lattice = table.lattice.emplace();
        lattice.type = lattice_name(crystal->lattice);
        lattice.cells = crystal->cells;
        lattice.layers = crystal->layers;
        lattice.height = crystal->height;
        table.density = spec.density;
    } else if (const auto* random = std::get_if<RandomStart>(&spec.start)) {
        LatticeTable& lattice = table.lattice.emplace();
        lattice.type = LatticeTable::random_places;
        lattice.atoms = random->atoms;
        table.density = spec.density;
    } else {
        table.file = start.string();
        table.velocities = spec.keep_velocities ? std::nullopt : std::optional<std::string>(SystemTable::maxwell);
    }
    table.temperature = spec.temperature;
    table.seed = static_cast<Index>(spec.seed);
    return table;
}

PotentialTable potential_table(const FluidSpec& spec) {
    const PairPotential& potential = spec.potential;
    PotentialTable table;
    static_cast<Cutoff&>(table) = potential.cutoff();
    table.type = potential.formula();
    table.truncation = potential.truncation();
    table.tail = PairPotential::takes_tail(potential.truncation()) ? std::optional(spec.tail) : std::nullopt;
    table.parameters[table.type] = potential.parameters();
    return table;
}

template <class Options>
Placed<Options> without_places(const Options& options) {
    Placed<Options> placed;
    static_cast<Options&>(placed) = options;
    return placed;
}

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
    tables.system = without_places(system_table(spec, start));
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

}  // namespace

std::string deck_text(const FluidSpec& spec, const RunFiles& files, Precision precision,
                      const std::filesystem::path& start) {
    require_no_mistakes(spec, precision);
    if (const std::string why = not_for_decks(spec); !why.empty()) {
        throw InputError(why);
    }
    return toml_document(table_of(tables_of(spec, files, precision, start)));
}

}  // namespace ljmd
