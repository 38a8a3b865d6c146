#include "ljmd/engine/fluid_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "ljmd/core/errors.hpp"
#include "ljmd/model/box_for_cutoff.hpp"

namespace ljmd {

namespace {

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
    complaints.add(stage.name.empty(), where, "it needs a name");
    complaints.add(!(stage.time_step > 0.0), where,
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
    complaints.add(!(stage.temperature > 0.0) && thermostat.canonical, where,
                   fmt::format("the thermostat {} needs a temperature above 0", thermostat.name));
}

void judge_start(const FluidSpec& spec, Complaints& complaints) {
    const auto* configuration = std::get_if<Configuration>(&spec.start);
    const bool has_velocities = configuration != nullptr && spec.keep_velocities && !configuration->velocities.empty();
    complaints.add(!spec.temperature && !has_velocities, "start",
                   "a temperature is needed, from which velocities are drawn");
    complaints.add(spec.temperature && !(*spec.temperature >= 0.0), "start", "the temperature is below 0");
    complaints.add(configuration == nullptr && !(spec.density > 0.0), "start",
                   fmt::format("the density is {}, it must be above 0", spec.density));
    complaints.add(configuration != nullptr && !(configuration->edges.minCoeff() > 0.0), "start",
                   "the edges of the box must be above 0");
    complaints.add(atoms_of(spec) < 1, "start", "there are no atoms");
    complaints.add(spec.tail && !PairPotential::takes_tail(spec.potential.truncation()), "potential",
                   fmt::format("the truncation '{}' takes no tail correction", spec.potential.truncation()));
    complaints.add(spec.sample_every < 1, "sample_every", "it must be at least 1");
}

void judge_analyses(const FluidSpec& spec, Complaints& complaints) {
    std::set<std::string> names;
    for (const ChosenAnalysis& analysis : spec.analyses) {
        complaints.add(!names.insert(analysis.plugin.name).second, "analysis " + analysis.plugin.name,
                       "it is there twice");
    }
    if (spec.analyses.empty()) {
        return;
    }
    const auto first = std::ranges::find_if(spec.stages, is_sampled);
    complaints.add(std::any_of(first, spec.stages.end(), [](const Stage& stage) { return stage.barostat.has_value(); }),
                   "analyses", "they need a box that stays as it is from the first sampled stage on");
    const double time_step = sampled_stage(spec.stages).time_step;
    const bool follows_time =
        std::ranges::any_of(spec.analyses, [](const ChosenAnalysis& analysis) { return analysis.plugin.follows_time; });
    complaints.add(
        follows_time &&
            std::ranges::any_of(spec.stages,
                                [&](const Stage& stage) { return stage.sample && stage.time_step != time_step; }),
        "analyses", "they compare configurations at equal times apart, so sampled stages need one time step");
}

}  // namespace

Index FluidSpec::total_steps() const {
    Index sum = 0;
    for (const Stage& stage : stages) {
        sum += stage.steps;
    }
    return sum;
}

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

const Stage& sampled_stage(const std::vector<Stage>& stages) {
    const auto first = std::ranges::find_if(stages, is_sampled);
    return first == stages.end() ? stages.back() : *first;
}

SampledRun sampled_run(const std::vector<Stage>& stages, std::uint64_t seed, Index atoms, const Box& box) {
    const Stage& stage = sampled_stage(stages);
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
    std::set<std::string> names;
    for (const Stage& stage : spec.stages) {
        judge_stage(stage, complaints);
        complaints.add(!names.insert(stage.name).second, fmt::format("stage '{}'", stage.name),
                       "another stage has this name");
    }
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
