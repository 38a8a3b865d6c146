#include "ljmd/engine/fluid_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "engine/mistakes/film_mistakes.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "engine/mistakes/until_mistakes.hpp"
#include "integrators/barostat.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "model/box_for_cutoff.hpp"
#include "neighbors/pair_search.hpp"

namespace ljmd {

namespace {

/// Collects sentences about the values of a specification.
class Complaints {
  public:
    void add(bool wrong, const std::string& where, const std::string& sentence) {
        if (wrong) {
            found_.push_back(fmt::format("{}: {}", where, sentence));
        }
    }
    void add(const std::vector<Mistake>& mistakes) {
        std::ranges::transform(mistakes, std::back_inserter(found_), in_words);
    }
    [[nodiscard]] bool empty() const { return found_.empty(); }
    [[nodiscard]] std::vector<std::string> take() { return std::move(found_); }

  private:
    std::vector<std::string> found_;
};

Box exact_box_of(const FluidSpec& spec) {
    if (const auto* configuration = std::get_if<Configuration>(&spec.start)) {
        return Box(configuration->edges);
    }
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        return lattice_box(*crystal, spec.density);
    }
    return cubic_box(atoms_of(spec), spec.density);
}

bool all_finite(const std::vector<Vec3>& vectors) {
    return std::ranges::all_of(vectors, [](const Vec3& v) { return v.allFinite(); });
}

void judge_configuration(const Configuration& configuration, Complaints& complaints) {
    const std::size_t atoms = configuration.positions.size();
    complaints.add(!(configuration.edges.allFinite() && configuration.edges.minCoeff() > 0.0), "start",
                   "the edges of the box must be above 0");
    complaints.add(!all_finite(configuration.positions) || !all_finite(configuration.velocities), "start",
                   "positions and velocities must be finite");
    const std::size_t velocities = configuration.velocities.size();
    complaints.add(velocities != 0 && velocities != atoms, "start",
                   fmt::format("{} velocities for {} atoms", velocities, atoms));
    const std::size_t masses = configuration.masses.size();
    complaints.add(masses != 0 && masses != atoms, "start", fmt::format("{} masses for {} atoms", masses, atoms));
    complaints.add(std::ranges::any_of(configuration.masses, [](double m) { return !(std::abs(m - 1.0) <= 1e-6); }),
                   "start", "in reduced units all atoms have mass 1");
}

void judge_start(const FluidSpec& spec, Complaints& complaints) {
    const auto* configuration = std::get_if<Configuration>(&spec.start);
    complaints.add(!spec.temperature && !keeps_velocities(spec), "start",
                   "a temperature is needed, from which velocities are drawn");
    complaints.add(spec.temperature && !(*spec.temperature >= 0.0 && std::isfinite(*spec.temperature)), "start",
                   fmt::format("the temperature is {}, it must be 0 or more", spec.temperature.value_or(0.0)));
    if (configuration != nullptr) {
        judge_configuration(*configuration, complaints);
    } else {
        complaints.add(!(spec.density >= min_density && std::isfinite(spec.density)), "start",
                       fmt::format("the density is {}, it must be at least {}", spec.density, min_density));
    }
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        complaints.add(lattice_mistakes(*crystal));
        if (complaints.empty()) {
            complaints.add(film_mistakes(*crystal, spec.density, spec.has_tail()));
        }
    } else {
        const Index atoms = atoms_of(spec);
        complaints.add(atoms < 1 || atoms > max_atoms, "start",
                       fmt::format("{} atoms: allowed are 1 to {}", atoms, max_atoms));
    }
    complaints.add(spec.sample_every < 1, "sample_every", "it must be at least 1");
}

/// Complain of what `choose` throws. @return whether it throws nothing
template <class Choose>
bool is_known(const std::string& where, Complaints& complaints, const Choose& choose) {
    try {
        static_cast<void>(choose());
        return true;
    } catch (const InputError& error) {
        complaints.add(true, where, error.what());
        return false;
    }
}

/// Whether all plug-ins and their options are known.
bool judge_choices(const FluidSpec& spec, Complaints& complaints) {
    std::set<std::string> names;
    bool known = true;
    for (const Choice& analysis : spec.analyses) {
        complaints.add(!names.insert(analysis.name).second, "analysis " + analysis.name, "it is there twice");
        known = is_known("analyses", complaints, [&] { return chosen_analysis(analysis); }) && known;
    }
    for (const Stage& stage : spec.stages) {
        known = is_known(fmt::format("stage '{}'", stage.name), complaints, [&] { return completed(stage); }) && known;
    }
    complaints.add(spec.stages.empty(), "stages", "at least one is needed; one of 0 steps evaluates the start");
    return known;
}

}  // namespace

bool NeighborSpec::keeps_list() const {
    return method == VerletList::name;
}

void NeighborSpec::describe(Description& description) {
    description.choice("method", pair_search_names(), method).meaning("how pairs are found; all give the same pairs");
    description.number("skin", skin)
        .dimension(Dimension::length)
        .unit("sigma")
        .at_least(0.0)
        .at_most(max_skin)
        .meaning(
            "the list holds pairs within cutoff + skin, and is rebuilt before any other pair is within the cutoff");
    description.integer("every", every)
        .at_least(1)
        .at_most(static_cast<double>(max_steps))
        .optional("whenever a pair could be missed")
        .meaning(
            "rebuild the list every so many steps, whatever the atoms do, as other programs may: pairs can be missed; "
            "verlet-list only");
    description.integer("tile", tile)
        .at_least(min_tile)
        .at_most(static_cast<double>(max_atoms))
        .optional("4000, or half of all atoms if that is less, but at least 200")
        .meaning(
            "atoms that a thread works on at once, at most about: smaller tiles let more threads share a small system, "
            "and take longer; changes the last digits of forces; verlet-list only");
}

bool FluidSpec::has_tail() const {
    return tail.value_or(PairPotential::takes_tail(potential.truncation()));
}

Interaction FluidSpec::interaction() const {
    return {potential, has_tail() ? TailCorrection(potential) : TailCorrection(), external != nullptr};
}

Index atoms_of(const FluidSpec& spec) {
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        return lattice_atoms(crystal->lattice, crystal->cells, crystal->layers_along_z());
    }
    if (const auto* random = std::get_if<RandomStart>(&spec.start)) {
        return random->atoms;
    }
    return static_cast<Index>(std::get<Configuration>(spec.start).positions.size());
}

Box lattice_box(const LatticeStart& start, double density) {
    Vec3 edges = crystal_edges(start.lattice, start.cells, start.layers_along_z(), density);
    edges.z() = start.height.value_or(edges.z());
    return Box(edges);
}

Box box_of(const FluidSpec& spec) {
    return box_for_cutoff(exact_box_of(spec), spec.potential.cutoff().radius);
}

std::vector<Stage> resolved_stages(const FluidSpec& spec) {
    std::vector<Stage> stages;
    for (const Stage& one : spec.stages) {
        Stage& stage = stages.emplace_back(completed(one));
        stage.seed = stage.seed == 0 ? spec.seed : stage.seed;
        stage.temperature = stage.temperature ? stage.temperature : spec.temperature;
    }
    return stages;
}

bool keeps_velocities(const FluidSpec& spec) {
    const auto* configuration = std::get_if<Configuration>(&spec.start);
    return configuration != nullptr && spec.keep_velocities && !configuration->velocities.empty();
}

SampledRun sampled_run(const std::vector<Stage>& stages, std::uint64_t seed, Index atoms, const Box& box) {
    const Stage& stage = stages[first_sampled(stages)];
    SampledRun run{atoms,       box,  stage.time_step,
                   stage.steps, seed, stage.thermostat ? stage.temperature : std::nullopt,
                   std::nullopt};
    run.ensemble = sampled_ensemble(stages);
    run.held_pressure = held_pressure(stage);
    for (const Stage& other : stages) {
        if (other.sample) {
            run.steps = std::max(run.steps, other.steps);
        }
    }
    return run;
}

Ensemble sampled_ensemble(const std::vector<Stage>& stages, bool external) {
    const auto sampled = [](const Stage& stage) { return stage.sample && stage.steps > 0; };
    const auto first = std::ranges::find_if(stages, sampled);
    if (std::any_of(first, stages.end(), [](const Stage& stage) { return stage.barostat.has_value(); })) {
        const bool one = std::ranges::count_if(stages, sampled) == 1 && first->barostat && !external;
        return one ? Ensemble::isothermal_isobaric : Ensemble::constant_pressure;
    }
    if (external || std::ranges::count_if(stages, sampled) != 1 || !conserves_energy(*first)) {
        return Ensemble::none;
    }
    return first->thermostat ? Ensemble::canonical : Ensemble::constant_energy;
}

Baths sampled_baths(const std::vector<Stage>& stages, Index sample_every) {
    const auto steps = static_cast<double>(sample_every);
    Baths baths;
    for (const Stage& stage : stages) {
        if (stage.sample && stage.thermostat) {
            const double time = chosen_thermostat(*stage.thermostat).options->kinetic_energy_relaxation();
            baths.exchange = std::max(baths.exchange, time / (stage.time_step * steps));
        }
        if (stage.sample && stage.barostat) {
            const double mobility =
                chosen_barostat(*stage.barostat).options->volume_mobility() * stage.time_step * steps;
            baths.volume_mobility = baths.volume_mobility > 0.0 ? std::min(baths.volume_mobility, mobility) : mobility;
        }
    }
    return baths;
}

bool conserves_energy(const Stage& stage, const ExternalForce* external) {
    return conserves_energy(stage) && (external == nullptr || external->has_energy());
}

std::vector<std::string> mistakes(const FluidSpec& spec, Precision precision) {
    Complaints complaints;
    judge_start(spec, complaints);
    if (!judge_choices(spec, complaints)) {
        return complaints.take();
    }
    complaints.add(potential_mistakes(spec.potential.truncation(), spec.potential.cutoff(), spec.has_tail()));
    complaints.add(search_mistakes(spec.neighbors, precision));
    complaints.add(stage_mistakes(spec.stages));
    complaints.add(fluid_stage_mistakes(resolved_stages(spec)));
    complaints.add(until_mistakes(spec.stages));
    complaints.add(external_force_mistakes(spec));
    complaints.add(analysis_need_mistakes(spec.analyses, spec.potential.truncation(), spec.stages));
    if (complaints.empty()) {  // else the height of the crystal may not be known
        complaints.add(homogeneity_mistakes(spec.analyses, is_film(spec)));
    }
    if (!spec.stages.empty()) {
        complaints.add(sampling_mistakes(spec.analyses, spec.stages));
    }
    complaints.add(precision == Precision::mixed && spec.potential.is_custom(), "potential",
                   "a formula of the program is computed in double precision");
    if (complaints.empty()) {  // else there may be no box
        try {
            complaints.add(box_mistakes(spec, atoms_of(spec), box_of(spec)));
        } catch (const InputError& no_box) {
            complaints.add(true, "start", no_box.what());
        }
    }
    return complaints.take();
}

void require_no_mistakes(const FluidSpec& spec, Precision precision) {
    if (const std::vector<std::string> found = mistakes(spec, precision); !found.empty()) {
        throw InputError(fmt::format("{}", fmt::join(found, "\n")));
    }
}

}  // namespace ljmd
