#include "engine/fluid_system.hpp"

#include <fmt/format.h>

#include "engine/mistakes/film_mistakes.hpp"
#include "execution/first_touch.hpp"
#include "execution/ranks.hpp"
#include "integrators/relaxation.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double noticeable_drift = 1e-6;  // speed of the centre of mass [sigma/tau]

/// @param place_of  the position of an atom by its id
template <class PlaceOf>
void place(State& state, const PlaceOf& place_of) {
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = place_of(state.ids()[static_cast<std::size_t>(i)]);
    }
}

void set_velocities(State& state, const FluidSpec& spec, const std::function<void(const std::string&)>& warn) {
    if (!keeps_velocities(spec)) {
        draw_velocities(state, spec.temperature.value(), spec.seed);
        return;
    }
    if (spec.external) {
        return;  // the centre of mass moves with it
    }
    const double drift = (total_momentum(state) / static_cast<double>(state.total())).norm();
    if (drift > noticeable_drift) {
        warn(fmt::format("the centre of mass moved with {:.3g} sigma/tau; its motion was removed", drift));
    }
    remove_momentum(state);
}

}  // namespace

PairForceField make_force_field(const FluidSpec& spec, const Execution& execution) {
    PairForceField force_field{
        spec.potential,
        make_pair_search(spec.neighbors.method, spec.neighbors.skin, spec.neighbors.every, spec.neighbors.tile),
        execution};
    force_field.set_external(spec.external);
    return force_field;
}

std::vector<std::unique_ptr<Analysis>> make_analyses(const FluidSpec& spec, const State& state) {
    std::vector<std::unique_ptr<Analysis>> analyses;
    if (spec.analyses.empty()) {
        return analyses;
    }
    SampledRun run = sampled_run(spec.stages, spec.seed, state.total(), state.box());
    run.interaction = spec.interaction();
    run.is_film = is_film(spec);
    for (const Choice& analysis : spec.analyses) {
        analyses.push_back(chosen_analysis(analysis).options->make(run));
    }
    return analyses;
}

FluidSystem empty_fluid(const FluidSpec& spec, Index atoms, const Box& box, const Execution& execution) {
    const FirstTouch first_touch(touched_by_threads(execution));
    FluidSystem fluid{
        State(atoms, box, execution), make_force_field(spec, execution), spec.interaction().tail, std::nullopt, {}};
    fluid.analyses = make_analyses(spec, fluid.state);
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start); crystal != nullptr && !crystal->height) {
        fluid.order.emplace(crystal->lattice, crystal->cells, crystal->layers_along_z());
    }
    return fluid;
}

void place_configuration(State& state, const Configuration& configuration) {
    const Box& box = state.box();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        const auto k = static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)]);
        const Vec3 n = box.crossings(configuration.positions[k]);
        if (!(n.cwiseAbs().maxCoeff() < 1e6)) {
            throw DataError(fmt::format("atom {} is more than a million edges away from its box", k + 1));
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

FluidSystem make_fluid(const FluidSpec& spec, const Execution& execution,
                       const std::function<void(const std::string&)>& warn) {
    const Index atoms = atoms_of(spec);
    const Box box = box_of(spec);
    if (spec.external && !execution.ranks().alone()) {
        throw InputError("an external force acts on all atoms at once: several ranks cannot share them");
    }
    FluidSystem fluid = empty_fluid(spec, atoms, box, execution);
    if (const auto* configuration = std::get_if<Configuration>(&spec.start)) {
        place_configuration(fluid.state, *configuration);
    } else if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        const Index layers = crystal->layers_along_z();
        Vec3 edges = box.edges();
        if (crystal->height) {
            edges.z() = crystal_edges(crystal->lattice, crystal->cells, layers, spec.density).z();
        }
        place(fluid.state,
              [&](Index id) { return lattice_site(crystal->lattice, crystal->cells, layers, edges, box, id); });
    } else {
        place(fluid.state, [&](Index id) { return random_position(box, spec.seed, id); });
        fluid.force_field.set_external(nullptr);  // overlaps are pushed apart, but atoms do not fall meanwhile
        fluid.relaxation_iterations = relax(fluid.state, fluid.force_field).iterations;
        fluid.force_field.set_external(spec.external);
    }
    set_velocities(fluid.state, spec, warn);
    return fluid;
}

}  // namespace ljmd
