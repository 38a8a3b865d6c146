#include "ljmd/deck/simulation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_potential.hpp"
#include "ljmd/deck/sampled_run.hpp"
#include "ljmd/integrators/relaxation.hpp"
#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/formats/configuration_reader.hpp"
#include "ljmd/model/box_for_cutoff.hpp"
#include "ljmd/model/lattice.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double noticeable_drift = 1e-6;  // speed of the centre of mass [sigma/tau]

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

void place(State& state, const std::vector<Vec3>& positions) {
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = positions[static_cast<std::size_t>(i)];
    }
}

void set_velocities(State& state, const Deck& deck, const Start& start,
                    const std::function<void(const std::string&)>& warn) {
    const Section& system = deck.system();
    if (keeps_velocities(system, start)) {
        const double drift = (total_momentum(state) / static_cast<double>(state.count())).norm();
        if (drift > noticeable_drift) {
            warn(fmt::format("the centre of mass moved with {:.3g} sigma/tau; its motion was removed", drift));
        }
        remove_momentum(state);
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
    draw_velocities(state, system.number("temperature"), static_cast<std::uint64_t>(system.integer("seed")));
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

bool wants_tail(const Deck& deck) {
    return deck.potential().has("tail") && deck.potential().flag("tail");
}

PairForceField make_force_field(const Deck& deck) {
    const Section& neighbors = deck.neighbors();
    const auto every = neighbors.has("every") ? std::optional<Index>(neighbors.integer("every")) : std::nullopt;
    return {pair_potential_of(deck.potential()),
            make_pair_search(neighbors.text("method"), neighbors.number("skin"), every),
            {default_simd_level(), precision_of(deck.performance().text("precision"))}};
}

void place_configuration(State& state, const Configuration& configuration) {
    const Box& box = state.box();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Vec3 n = box.crossings(configuration.positions[k]);
        if (!(n.cwiseAbs().maxCoeff() < 1e6)) {
            throw DataError(fmt::format("atom {} is more than a million edges away from its box", i + 1));
        }
        r.col(i) = box.snap(configuration.positions[k] - n.cwiseProduct(box.edges()));
        state.set_image(i, n.cast<int>());
        if (!configuration.velocities.empty()) {
            v.col(i) = configuration.velocities[k];
        }
    }
    state.wrap();  // rounding to the grid may have put an atom onto the far wall
    for (const double mass : configuration.masses) {
        if (std::abs(mass - 1.0) > 1e-6) {
            throw DataError(
                fmt::format("the file has an atom of mass {}; in reduced units all atoms have mass 1", mass));
        }
    }
}

Interaction interaction_of(const Deck& deck) {
    const PairPotential potential = pair_potential_of(deck.potential());
    return {potential, wants_tail(deck) ? TailCorrection(potential) : TailCorrection()};
}

Simulation empty_simulation(const Deck& deck, Index atoms, const Box& box) {
    Simulation simulation{State(atoms, box), make_force_field(deck), interaction_of(deck).tail, std::nullopt, {}};
    const Section& system = deck.system();
    if (system.has("lattice") && !is_random(system.section("lattice"))) {
        const Section& lattice = system.section("lattice");
        simulation.order.emplace(lattice_type(lattice), lattice_cells(lattice));
    }
    simulation.analyses = make_analyses(deck, simulation);
    return simulation;
}

std::vector<std::unique_ptr<Analysis>> make_analyses(const Deck& deck, const Simulation& simulation) {
    const Section& analysis = deck.root.section("analysis");
    SampledRun run = sampled_run(deck.root, simulation.state.count(), simulation.state.box());
    run.interaction = interaction_of(deck);
    std::vector<std::unique_ptr<Analysis>> analyses;
    for (const auto& method : all_analyses()) {
        if (analysis.has(method.name)) {
            analyses.push_back(choose(method, analysis.section(method.name)).options->make(run));
        }
    }
    return analyses;
}

Simulation make_simulation(const Deck& deck, Start start, const std::function<void(const std::string&)>& warn) {
    const Section& system = deck.system();
    Simulation simulation = empty_simulation(deck, start.atoms, start.box);
    if (start.configuration) {
        place_configuration(simulation.state, *start.configuration);
    } else if (const Section& lattice = system.section("lattice"); is_random(lattice)) {
        place(simulation.state,
              random_positions(start.atoms, start.box, static_cast<std::uint64_t>(system.integer("seed"))));
        simulation.relaxation_iterations = relax(simulation.state, simulation.force_field).iterations;
    } else {
        place(simulation.state, lattice_sites(lattice_type(lattice), lattice_cells(lattice), start.box));
    }
    set_velocities(simulation.state, deck, start, warn);
    return simulation;
}

}  // namespace ljmd
