#include "ljmd/engine/fluid_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ljmd/core/errors.hpp"
#include "ljmd/model/box_for_cutoff.hpp"
#include "ljmd/neighbors/pair_search.hpp"

namespace ljmd {

namespace {

constexpr Index max_cells = Index{1} << 20U;  // along an edge, see lattice_atoms()
constexpr Index max_atoms = Index{1} << 40U;
constexpr double max_total_steps = 0x1p62;

bool is_sampled(const Stage& stage) {
    return stage.sample;
}

/// Collects sentences about one part of a specification.
class Complaints {
  public:
    void add(bool wrong, const std::string& where, const std::string& sentence) {
        if (wrong) {
            found_.push_back(fmt::format("{}: {}", where, sentence));
        }
    }
    [[nodiscard]] std::vector<std::string> take() { return std::move(found_); }

  private:
    std::vector<std::string> found_;
};

void judge_stage(const Stage& stage, Complaints& complaints) {
    const std::string where = fmt::format("stage '{}'", stage.name);
    const bool incomplete = !stage.integrator.options || (stage.thermostat && !stage.thermostat->options) ||
                            (stage.barostat && !stage.barostat->options);
    complaints.add(incomplete, where,
                   "integrator, thermostat and barostat are chosen by integrator(), thermostat() "
                   "and barostat()");
    if (incomplete) {
        return;
    }
    complaints.add(stage.name.empty(), where, "it needs a name");
    complaints.add(!(stage.time_step > 0.0 && std::isfinite(stage.time_step)), where,
                   fmt::format("the time step is {}, it must be above 0", stage.time_step));
    complaints.add(stage.steps < 0, where, fmt::format("{} steps: allowed are 0 and more", stage.steps));
    const auto& method = stage.integrator.plugin;
    complaints.add(method.unbounded_only, where, fmt::format("the integrator {} is for few bodies only", method.name));
    if (stage.barostat && !(stage.thermostat && stage.thermostat->plugin.canonical)) {
        complaints.add(true, where, "a barostat needs a canonical thermostat beside it");
    }
    if (!stage.thermostat) {
        return;
    }
    const ThermostatMethod& thermostat = stage.thermostat->plugin;
    complaints.add(thermostat.every_step && method.name != "velocity-verlet", where,
                   fmt::format("the thermostat {} is a part of the steps of velocity-verlet; the integrator is {}",
                               thermostat.name, method.name));
    const bool warm = thermostat.canonical ? stage.temperature > 0.0 : stage.temperature >= 0.0;
    complaints.add(!(warm && std::isfinite(stage.temperature)), where,
                   fmt::format("the thermostat {} needs a temperature {}, found {}", thermostat.name,
                               thermostat.canonical ? "above 0" : "of 0 or more", stage.temperature));
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
    const bool has_velocities = configuration != nullptr && spec.keep_velocities && !configuration->velocities.empty();
    complaints.add(!spec.temperature && !has_velocities, "start",
                   "a temperature is needed, from which velocities are drawn");
    complaints.add(spec.temperature && !(*spec.temperature >= 0.0 && std::isfinite(*spec.temperature)), "start",
                   fmt::format("the temperature is {}, it must be 0 or more", spec.temperature.value_or(0.0)));
    if (configuration != nullptr) {
        judge_configuration(*configuration, complaints);
    } else {
        complaints.add(!(spec.density > 0.0 && std::isfinite(spec.density)), "start",
                       fmt::format("the density is {}, it must be above 0", spec.density));
    }
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        complaints.add(crystal->cells < 1 || crystal->cells > max_cells, "start",
                       fmt::format("{} cells along an edge: allowed are 1 to {}", crystal->cells, max_cells));
    } else {
        const Index atoms = atoms_of(spec);
        complaints.add(atoms < 1 || atoms > max_atoms, "start",
                       fmt::format("{} atoms: allowed are 1 to {}", atoms, max_atoms));
    }
    complaints.add(spec.sample_every < 1, "sample_every", "it must be at least 1");
}

void judge_interaction(const FluidSpec& spec, Complaints& complaints) {
    const PairPotential& potential = spec.potential;
    const Cutoff& cutoff = potential.cutoff();
    complaints.add(!(cutoff.radius > 0.0 && std::isfinite(cutoff.radius)), "potential",
                   fmt::format("the cutoff is {}, it must be above 0", cutoff.radius));
    complaints.add(
        potential.truncation() == "switched" && !(cutoff.switch_start > 0.0 && cutoff.switch_start < cutoff.radius),
        "potential",
        fmt::format("the switch starts at {}, it must be above 0 and below the cutoff", cutoff.switch_start));
    complaints.add(spec.tail && !PairPotential::takes_tail(potential.truncation()), "potential",
                   fmt::format("the truncation '{}' takes no tail correction", potential.truncation()));
    const NeighborSpec& neighbors = spec.neighbors;
    const std::vector<std::string> methods = pair_search_names();
    complaints.add(std::ranges::find(methods, neighbors.method) == methods.end(), "neighbors",
                   fmt::format("unknown method '{}', allowed: {}", neighbors.method, fmt::join(methods, ", ")));
    complaints.add(!(neighbors.skin >= 0.0 && neighbors.skin <= max_skin), "neighbors",
                   fmt::format("the skin is {}, allowed are 0 to {}", neighbors.skin, max_skin));
    complaints.add(neighbors.every && (*neighbors.every < 1 || neighbors.method != "verlet-list"), "neighbors",
                   "'every' must be at least 1, and is for the method verlet-list");
}

void judge_analyses(const FluidSpec& spec, Complaints& complaints) {
    std::set<std::string> names;
    for (const ChosenAnalysis& analysis : spec.analyses) {
        complaints.add(!analysis.options, "analyses", "each is chosen by analysis()");
        complaints.add(!names.insert(analysis.plugin.name).second, "analysis " + analysis.plugin.name,
                       "it is there twice");
    }
    if (spec.analyses.empty()) {
        return;
    }
    const auto first = std::ranges::find_if(spec.stages, is_sampled);
    complaints.add(std::any_of(first, spec.stages.end(), [](const Stage& stage) { return stage.barostat.has_value(); }),
                   "analyses", "they need a box that stays as it is from the first sampled stage on");
    const double time_step = spec.stages[first_sampled(spec.stages)].time_step;
    const bool follows_time =
        std::ranges::any_of(spec.analyses, [](const ChosenAnalysis& analysis) { return analysis.plugin.follows_time; });
    complaints.add(
        follows_time &&
            std::ranges::any_of(spec.stages,
                                [&](const Stage& stage) { return stage.sample && stage.time_step != time_step; }),
        "analyses", "they compare configurations at equal times apart, so sampled stages need one time step");
}

}  // namespace

Interaction FluidSpec::interaction() const {
    return {potential, tail ? TailCorrection(potential) : TailCorrection()};
}

Index atoms_of(const FluidSpec& spec) {
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        return lattice_atoms(crystal->lattice, crystal->cells);
    }
    if (const auto* random = std::get_if<RandomStart>(&spec.start)) {
        return random->atoms;
    }
    return static_cast<Index>(std::get<Configuration>(spec.start).positions.size());
}

Box box_of(const FluidSpec& spec) {
    const auto* configuration = std::get_if<Configuration>(&spec.start);
    const Box box = configuration != nullptr ? Box(configuration->edges) : cubic_box(atoms_of(spec), spec.density);
    return box_for_cutoff(box, spec.potential.cutoff().radius);
}

SampledRun sampled_run(const std::vector<Stage>& stages, std::uint64_t seed, Index atoms, const Box& box) {
    const Stage& stage = stages[first_sampled(stages)];
    SampledRun run{atoms,       box,  stage.time_step,
                   stage.steps, seed, stage.thermostat ? std::optional(stage.temperature) : std::nullopt,
                   std::nullopt};
    for (const Stage& other : stages) {
        if (other.sample) {
            run.steps = std::max(run.steps, other.steps);
        }
    }
    return run;
}

Ensemble sampled_ensemble(const std::vector<Stage>& stages) {
    const auto sampled = [](const Stage& stage) { return stage.sample && stage.steps > 0; };
    const auto first = std::ranges::find_if(stages, sampled);
    if (std::any_of(first, stages.end(), [](const Stage& stage) { return stage.barostat.has_value(); })) {
        return Ensemble::constant_pressure;
    }
    if (std::ranges::count_if(stages, sampled) != 1 || !conserves_energy(*first)) {
        return Ensemble::none;
    }
    return first->thermostat ? Ensemble::canonical : Ensemble::constant_energy;
}

std::vector<std::string> mistakes(const FluidSpec& spec) {
    Complaints complaints;
    judge_start(spec, complaints);
    judge_interaction(spec, complaints);
    std::set<std::string> names;
    for (const Stage& stage : spec.stages) {
        judge_stage(stage, complaints);
        complaints.add(!names.insert(stage.name).second, fmt::format("stage '{}'", stage.name),
                       "another stage has this name");
    }
    double steps = 0.0;
    for (const Stage& stage : spec.stages) {
        steps += static_cast<double>(stage.steps);
    }
    complaints.add(steps > max_total_steps, "stages", "their steps add up to more than 2^62");
    complaints.add(spec.stages.empty(), "stages", "at least one is needed; one of 0 steps evaluates the start");
    if (!spec.stages.empty()) {
        judge_analyses(spec, complaints);
    }
    std::vector<std::string> found = complaints.take();
    if (!found.empty()) {  // there may be no box
        return found;
    }
    return box_mistakes(spec, atoms_of(spec), box_of(spec));
}

std::vector<std::string> box_mistakes(const FluidSpec& spec, Index atoms, const Box& box) {
    Complaints complaints;
    const double radius = spec.potential.cutoff().radius;
    complaints.add(radius > 0.5 * box.shortest_edge(), "potential",
                   fmt::format("the cutoff is {}, more than half the shortest edge {:.6g} of the box", radius,
                               box.shortest_edge()));
    const SampledRun run = sampled_run(spec.stages, spec.seed, atoms, box);
    for (const ChosenAnalysis& analysis : spec.analyses) {
        for (const auto& [key, message] : analysis.options->check(run)) {
            complaints.add(true, "analysis " + analysis.plugin.name, message);
        }
    }
    return complaints.take();
}

}  // namespace ljmd
