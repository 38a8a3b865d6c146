#include "ljmd/deck/fluid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/analysis_sense.hpp"
#include "ljmd/deck/deck_potential.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/formats/configuration_reader.hpp"
#include "ljmd/model/box_for_cutoff.hpp"
#include "ljmd/model/lattice.hpp"

namespace ljmd {

namespace {

std::variant<LatticeStart, RandomStart, Configuration> start_of(const Section& system) {
    if (!system.has("lattice")) {
        return Configuration{};
    }
    const Section& table = system.section("lattice");
    if (table.text("type") == random_lattice) {
        return RandomStart{table.integer("atoms")};
    }
    const Lattice lattice = find_lattice(table.text("type"));
    return LatticeStart{
        lattice, table.has("cells") ? table.integer("cells") : nearest_cells(lattice, table.integer("atoms")).below};
}

Start start_from_file(const Section& system, const std::optional<SubstanceUnits>& units) {
    const std::string comment = system.has("xyz_comment") ? system.text("xyz_comment") : "";
    Configuration configuration = read_configuration(configuration_file(system.text("file")), units, comment);
    const auto atoms = static_cast<Index>(configuration.positions.size());
    Vec3 edges = configuration.edges;
    if (system.has("density")) {
        const double factor = std::cbrt(static_cast<double>(atoms) / (edges.prod() * system.number("density")));
        edges *= factor;
        configuration.edges = edges;
        for (Vec3& r : configuration.positions) {
            r *= factor;
        }
    }
    return {atoms, Box(edges), std::move(configuration)};
}

/// @throws DataError when the velocities that the deck asks for cannot be had
void require_velocities(const Section& system, const Start& start) {
    if (keeps_velocities(system, start)) {
        return;
    }
    if (system.has("velocities") && system.text("velocities") == "file") {
        throw DataError(
            fmt::format("{} has no velocities; set velocities = \"maxwell\" and a temperature", system.text("file")));
    }
    if (!system.has("temperature")) {
        throw DataError(
            fmt::format("{} has no velocities; give 'temperature' in [system] to draw them", system.text("file")));
    }
}

}  // namespace

std::filesystem::path configuration_file(const std::string& file) {
    const std::filesystem::path path(file);
    return input_is_directory(path) ? path / "final.xyz" : path;
}

bool keeps_velocities(const Section& system, const Start& start) {
    const bool file_has_them = start.configuration && !start.configuration->velocities.empty();
    return file_has_them && !(system.has("velocities") && system.text("velocities") == "maxwell");
}

Start find_start(const Deck& deck) {
    const FluidSpec spec = fluid_spec(deck);
    if (!deck.system().has("file")) {
        return {atoms_of(spec), box_of(spec), std::nullopt};
    }
    Start start = start_from_file(deck.system(), deck.units);
    start.box = box_for_cutoff(start.box, spec.potential.cutoff().radius);
    return start;
}

SampledRun sampled_run(const Deck& deck, Index atoms, const Box& box) {
    return sampled_run(deck.stages, static_cast<std::uint64_t>(deck.system().integer("seed")), atoms, box);
}

NeighborSpec neighbor_spec(const Section& neighbors) {
    return {neighbors.text("method"), neighbors.number("skin"),
            neighbors.has("every") ? std::optional<Index>(neighbors.integer("every")) : std::nullopt};
}

FluidSpec fluid_spec(const Deck& deck) {
    const Section& system = deck.system();
    const Section& potential = deck.potential();
    FluidSpec spec{.start = start_of(system),
                   .potential = pair_potential_of(potential),
                   .tail = potential.has("tail") && potential.flag("tail"),
                   .neighbors = neighbor_spec(deck.neighbors()),
                   .stages = deck.stages,
                   .sample_every = deck.thermo_every,
                   .analyses = chosen_analyses(deck.root.section("analysis")),
                   .units = deck.units};
    if (system.has("density")) {
        spec.density = system.number("density");
    }
    if (system.has("temperature")) {
        spec.temperature = system.number("temperature");
    }
    spec.keep_velocities = !(system.has("velocities") && system.text("velocities") == "maxwell");
    spec.seed = static_cast<std::uint64_t>(system.integer("seed"));
    return spec;
}

FluidSpec fluid_spec(const Deck& deck, Start start) {
    require_velocities(deck.system(), start);
    FluidSpec spec = fluid_spec(deck);
    if (start.configuration) {
        spec.start = std::move(*start.configuration);
    }
    return spec;
}

}  // namespace ljmd
