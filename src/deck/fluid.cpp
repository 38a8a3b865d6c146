#include "ljmd/deck/fluid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_potential.hpp"
#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/formats/configuration_reader.hpp"
#include "ljmd/model/box_for_cutoff.hpp"
#include "ljmd/model/lattice.hpp"

namespace ljmd {

namespace {

Lattice lattice_type(const Section& lattice) {
    return lattice.text("type") == "fcc" ? Lattice::fcc : Lattice::simple_cubic;
}

bool is_random(const Section& lattice) {
    return lattice.text("type") == "random";
}

Index lattice_cells(const Section& lattice) {
    return lattice.has("cells") ? lattice.integer("cells")
                                : nearest_cells(lattice_type(lattice), lattice.integer("atoms")).below;
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

Start start_from_lattice(const Section& system) {
    const Section& lattice = system.section("lattice");
    const Index atoms =
        is_random(lattice) ? lattice.integer("atoms") : lattice_atoms(lattice_type(lattice), lattice_cells(lattice));
    return {atoms, cubic_box(atoms, system.number("density")), std::nullopt};
}

LatticeStart lattice_start_of(const Section& lattice) {
    return {lattice_type(lattice), lattice_cells(lattice)};
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

std::vector<ChosenAnalysis> chosen_analyses(const Section& analysis) {
    std::vector<ChosenAnalysis> chosen;
    for (const auto& method : all_analyses()) {
        if (analysis.has(method.name)) {
            chosen.push_back(choose(method, analysis.section(method.name)));
        }
    }
    return chosen;
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
    const Section& system = deck.system();
    Start start = system.has("file") ? start_from_file(system, deck.units) : start_from_lattice(system);
    start.box = box_for_cutoff(start.box, deck.potential().number("cutoff"));
    return start;
}

FluidSpec fluid_spec(const Deck& deck) {
    const Section& system = deck.system();
    const Section& potential = deck.potential();
    const Section& neighbors = deck.neighbors();
    FluidSpec spec{
        .potential = pair_potential_of(potential),
        .tail = potential.has("tail") && potential.flag("tail"),
        .neighbors = {neighbors.text("method"), neighbors.number("skin"),
                      neighbors.has("every") ? std::optional<Index>(neighbors.integer("every")) : std::nullopt},
        .stages = deck.stages,
        .sample_every = deck.thermo_every,
        .analyses = chosen_analyses(deck.root.section("analysis")),
        .units = deck.units};
    if (!system.has("lattice")) {
        spec.start = Configuration{};
    } else if (const Section& lattice = system.section("lattice"); is_random(lattice)) {
        spec.start = RandomStart{lattice.integer("atoms")};
    } else {
        spec.start = lattice_start_of(lattice);
    }
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
