#include "deck/fluid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/deck_stages.hpp"
#include "io/files/input_file.hpp"
#include "io/formats/configuration_reader.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/elementary.hpp"
#include "model/box_for_cutoff.hpp"

namespace ljmd {

namespace {

Start start_from_file(const SystemTable& system, const std::optional<SubstanceUnits>& units) {
    const std::string comment = system.xyz_comment.value_or("");
    Configuration configuration = read_configuration(configuration_file(*system.file), units, comment);
    const auto atoms = static_cast<Index>(configuration.positions.size());
    Vec3 edges = configuration.edges;
    if (system.density) {
        const double factor = cube_root(static_cast<double>(atoms) / (edges.prod() * *system.density));
        edges *= factor;
        configuration.edges = edges;
        for (Vec3& r : configuration.positions) {
            r *= factor;
        }
    }
    return {atoms, Box(edges), std::move(configuration)};
}

/// @throws DataError when the velocities that the deck asks for cannot be had
void require_velocities(const SystemTable& system, const Start& start) {
    if (keeps_velocities(system, start)) {
        return;
    }
    if (system.wants_velocities_of_file()) {
        throw DataError(
            fmt::format("{} has no velocities; set velocities = \"maxwell\" and a temperature", *system.file));
    }
    if (!system.temperature) {
        throw DataError(fmt::format("{} has no velocities; give 'temperature' in [system] to draw them", *system.file));
    }
}

}  // namespace

std::filesystem::path configuration_file(const std::string& file) {
    const std::filesystem::path path(file);
    return input_is_directory(path) ? path / "final.xyz" : path;
}

bool keeps_velocities(const SystemTable& system, const Start& start) {
    const bool file_has_them = start.configuration && !start.configuration->velocities.empty();
    return file_has_them && !system.draws_velocities();
}

Start find_start(const Deck& deck) {
    const FluidSpec spec = fluid_spec(deck);
    if (!deck.system().file) {
        return {atoms_of(spec), box_of(spec), std::nullopt};
    }
    Start start = start_from_file(deck.system(), deck.units());
    start.box = box_for_cutoff(start.box, spec.potential.cutoff().radius);
    return start;
}

SampledRun sampled_run(const Deck& deck, Index atoms, const Box& box) {
    return sampled_run(deck.stages(), std::get<FluidSpec>(deck.spec).seed, atoms, box);
}

FluidSpec spec_of(const FluidTables& tables, const std::optional<SubstanceUnits>& units) {
    const SystemTable& system = tables.system;
    FluidSpec spec{.start = system.start(),
                   .temperature = system.temperature,
                   .keep_velocities = !system.draws_velocities(),
                   .seed = static_cast<std::uint64_t>(system.seed),
                   .potential = pair_potential_of(tables.potential),
                   .tail = tables.potential.has_tail(),
                   .neighbors = tables.neighbors,
                   .stages = stages_of(tables),
                   .sample_every = tables.output.thermo.every,
                   .analyses = tables.analysis.asked,
                   .units = units};
    if (system.density) {
        spec.density = *system.density;
    }
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
