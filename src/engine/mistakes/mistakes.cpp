#include "engine/mistakes/mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "core/text.hpp"
#include "engine/mistakes/keys_of_mistakes.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "neighbors/pair_search.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_name = 64;
constexpr double max_total_steps = 0x1p62;

/// Collects mistakes in one part of a specification.
class Mistakes {
  public:
    explicit Mistakes(std::string table, std::string name = {}, std::size_t index = 0)
        : table_(std::move(table)), name_(std::move(name)), index_(index) {}

    /// @param sentence  the whole of it
    void add(std::vector<std::string> keys, std::string sentence, std::string hint = {}) {
        found_.push_back({table_, name_, index_, std::move(sentence), false, std::move(keys), std::move(hint)});
    }
    /// @param predicate  follows the name of the first key
    void add_of_key(std::vector<std::string> keys, std::string predicate, std::string hint = {}) {
        found_.push_back({table_, name_, index_, std::move(predicate), true, std::move(keys), std::move(hint)});
    }
    void move_to(std::vector<Mistake>& all) { std::ranges::move(found_, std::back_inserter(all)); }
    [[nodiscard]] std::vector<Mistake> take() { return std::move(found_); }

  private:
    std::string table_;
    std::string name_;
    std::size_t index_;
    std::vector<Mistake> found_;
};

/// Call `judge(stage, mistakes)` with each stage.
template <class Judge>
std::vector<Mistake> judged(const std::vector<Stage>& stages, const Judge& judge) {
    std::vector<Mistake> all;
    for (std::size_t k = 0; k < stages.size(); ++k) {
        Mistakes found("stage", stages[k].name, k);
        judge(stages[k], found);
        found.move_to(all);
    }
    return all;
}

void judge_thermostat(const Stage& stage, Mistakes& found) {
    const ThermostatMethod thermostat = find_thermostat(stage.thermostat->name);
    const std::string& integrator = stage.integrator.name;
    if (thermostat.every_step && !find_integrator(integrator).takes_thermostat) {
        found.add({type_key(&Stage::thermostat), key(&Stage::integrator)},
                  fmt::format("the thermostat {} is a part of the steps of {}; the integrator is {}", thermostat.name,
                              fmt::join(integrators_with_thermostat(), " or "), integrator));
    }
    const bool finite = stage.temperature && std::isfinite(*stage.temperature);
    if (thermostat.canonical && !(finite && *stage.temperature > 0.0)) {
        found.add({type_key(&Stage::thermostat), key(&Stage::temperature)},
                  fmt::format("the thermostat {} needs a temperature above 0", thermostat.name),
                  "rescale can take it to 0");
    } else if (!(finite && *stage.temperature >= 0.0)) {
        found.add({type_key(&Stage::thermostat), key(&Stage::temperature)},
                  fmt::format("the thermostat {} needs a temperature of 0 or more", thermostat.name));
    }
}

std::string label_of(const Mistake& mistake) {
    if (mistake.table == "stage") {
        return fmt::format("stage '{}'", mistake.name);
    }
    if (mistake.table == "analysis") {
        return fmt::format("analysis {}", mistake.name);
    }
    if (mistake.table == "body") {
        return fmt::format("body {}", mistake.index + 1);
    }
    return mistake.table == "system" ? "start" : mistake.table;
}

}  // namespace

std::string in_words(const Mistake& mistake) {
    return fmt::format("{}: {}{}{}{}", label_of(mistake), mistake.follows_key ? mistake.keys.front() + " " : "",
                       mistake.message, mistake.hint.empty() ? "" : "; ", mistake.hint);
}

std::vector<Mistake> stage_mistakes(const std::vector<Stage>& stages) {
    std::set<std::string> names;
    double steps = 0.0;
    std::vector<Mistake> all = judged(stages, [&](const Stage& stage, Mistakes& found) {
        if (stage.name.empty() || printable(stage.name, longest_name) != stage.name) {
            found.add_of_key({key(&Stage::name)}, fmt::format("must be 1 to {} printable characters", longest_name));
        } else if (!names.insert(stage.name).second) {
            found.add({key(&Stage::name)}, fmt::format("two stages are called '{}'", stage.name));
        }
        if (!(stage.time_step > 0.0 && std::isfinite(stage.time_step))) {
            found.add({key(&Stage::time_step)},
                      fmt::format("the time step is {}, it must be above 0", stage.time_step));
        }
        if (stage.steps < 0) {
            found.add({key(&Stage::steps)}, fmt::format("{} steps: allowed are 0 and more", stage.steps));
        }
        steps += static_cast<double>(stage.steps);
    });
    if (steps > max_total_steps) {
        Mistakes found("stage", stages.front().name);
        found.add({key(&Stage::steps)}, "the steps of all stages add up to more than 2^62");
        found.move_to(all);
    }
    return all;
}

std::vector<Mistake> fluid_stage_mistakes(const std::vector<Stage>& stages) {
    bool sampled = false;
    bool turned = false;  // since it was sampled
    return judged(stages, [&](const Stage& stage, Mistakes& found) {
        const bool samples = stage.sample && stage.steps > 0;
        turned = turned || (sampled && stage.reverse);
        if (samples && turned) {
            found.add({key(&Stage::sample), key(&Stage::reverse)},
                      "this stage samples again what was sampled before the motion was turned round",
                      "set sample = false in it, or in the stages before the reversal");
        }
        sampled = sampled || samples;
        if (find_integrator(stage.integrator.name).unbounded_only) {
            found.add({key(&Stage::integrator)},
                      fmt::format("the integrator {} is for few bodies only", stage.integrator.name));
        }
        if (stage.barostat && !(stage.thermostat && find_thermostat(stage.thermostat->name).canonical)) {
            found.add({key(&Stage::barostat), type_key(&Stage::thermostat)},
                      "a barostat needs a canonical thermostat beside it", "e.g. stochastic-rescaling");
        }
        if (stage.thermostat) {
            judge_thermostat(stage, found);
        }
        if (stage.total_energy && !std::isfinite(*stage.total_energy)) {
            found.add_of_key({key(&Stage::total_energy)}, "must be a finite number");
        } else if (stage.total_energy && stage.thermostat) {
            found.add({key(&Stage::total_energy), type_key(&Stage::thermostat)},
                      "a total energy is kept at constant energy only: a thermostat would change it",
                      "leave one of the two out");
        }
    });
}

std::vector<Mistake> external_force_mistakes(const FluidSpec& spec) {
    if (!spec.external) {
        return {};
    }
    const std::string name = spec.external->name();
    if (name.empty() || printable(name, longest_name) != name) {
        Mistakes found("external force");
        found.add({}, fmt::format("its name must be 1 to {} printable characters", longest_name));
        return found.take();
    }
    std::vector<Mistake> all = judged(spec.stages, [&](const Stage& stage, Mistakes& found) {
        if (stage.total_energy && !spec.external->has_energy()) {
            found.add(
                {key(&Stage::total_energy)},
                fmt::format("a total energy needs the energy of the external force '{}', which does not tell it", name),
                "see ExternalForce::has_energy()");
        }
        if (stage.barostat && !spec.external->has_virial()) {
            found.add(
                {key(&Stage::barostat)},
                fmt::format("a barostat needs the virial of the external force '{}', which does not tell it", name),
                "see ExternalForce::has_virial(); a field that scales with the box has virial 0");
        }
    });
    for (const Choice& analysis : spec.analyses) {
        if (find_analysis(analysis.name).needs.interaction) {
            Mistakes found("analysis", analysis.name);
            found.add({}, fmt::format("it is for a homogeneous fluid, in which the pair forces act alone; here the "
                                      "external force '{}' acts, too",
                                      name));
            found.move_to(all);
        }
    }
    return all;
}

std::vector<Mistake> few_body_sampling_mistakes(const std::vector<Stage>& stages) {
    const Stage* last_sampled = nullptr;
    const Stage* previous = nullptr;
    return judged(stages, [&](const Stage& stage, Mistakes& found) {
        if (stage.sample && stage.reverse) {
            found.add({key(&Stage::reverse)},
                      fmt::format("stage '{}' runs backwards: analyses cannot sample it", stage.name),
                      "set sample = false in it");
        } else if (stage.sample && last_sampled != nullptr && last_sampled != previous) {
            found.add({key(&Stage::sample)},
                      fmt::format("stage '{}' is sampled and so was '{}', but '{}' between them is not: "
                                  "analyses cannot leave a gap",
                                  stage.name, last_sampled->name, previous->name));
        }
        last_sampled = stage.sample ? &stage : last_sampled;
        previous = &stage;
    });
}

std::vector<Mistake> lattice_mistakes(const LatticeStart& lattice) {
    Mistakes found("system");
    if (lattice.cells < 1 || lattice.cells > max_cells) {
        found.add({lattice_key(&LatticeTable::cells)},
                  fmt::format("{} cells along an edge: allowed are 1 to {}", lattice.cells, max_cells));
    } else if (lattice.layers && (*lattice.layers < 1 || *lattice.layers > max_layers)) {
        found.add({lattice_key(&LatticeTable::layers)},
                  fmt::format("{} layers: allowed are 1 to {}", *lattice.layers, max_layers));
    } else if (const Index atoms = lattice_atoms(lattice.lattice, lattice.cells, lattice.layers_along_z());
               atoms > max_atoms) {
        found.add_of_key({lattice_key(&LatticeTable::cells)},
                         fmt::format("makes {} atoms, more than {}", atoms, max_atoms));
    }
    return found.take();
}

std::vector<Mistake> potential_mistakes(const std::string& truncation, const Cutoff& cutoff, bool tail) {
    Mistakes found("potential");
    const std::string meaningless = fmt::format("has no meaning for truncation = \"{}\"", truncation);
    if (!(cutoff.radius >= min_cutoff && std::isfinite(cutoff.radius))) {
        found.add({potential_key(&PotentialTable::radius)},
                  fmt::format("the cutoff is {}, it must be at least {}", cutoff.radius, min_cutoff));
    } else if (PairPotential::takes_switch_start(truncation) && !(cutoff.switch_start > 0.0)) {
        found.add({potential_key(&PotentialTable::switch_start)},
                  fmt::format("the switch starts at {}, it must be above 0", cutoff.switch_start));
    } else if (PairPotential::takes_switch_start(truncation) && !(cutoff.switch_start < cutoff.radius)) {
        found.add_of_key({potential_key(&PotentialTable::switch_start), potential_key(&PotentialTable::radius)},
                         fmt::format("is {}, not below the cutoff {}", cutoff.switch_start, cutoff.radius));
    } else if (!PairPotential::takes_switch_start(truncation) && cutoff.switch_start != 0.0) {
        found.add_of_key({potential_key(&PotentialTable::switch_start), potential_key(&PotentialTable::truncation)},
                         meaningless, "only \"switched\" begins before the cutoff");
    }
    if (tail && !PairPotential::takes_tail(truncation)) {
        found.add_of_key({potential_key(&PotentialTable::tail), potential_key(&PotentialTable::truncation)},
                         meaningless, "a shifted potential is another potential: no tail makes it the full one");
    }
    return found.take();
}

std::vector<Mistake> search_mistakes(const NeighborSpec& neighbors, Precision precision) {
    Mistakes found("neighbors");
    const std::vector<std::string> methods = pair_search_names();
    if (std::ranges::find(methods, neighbors.method) == methods.end()) {
        found.add({key(&NeighborSpec::method)},
                  fmt::format("unknown method '{}', allowed: {}", neighbors.method, fmt::join(methods, ", ")));
        return found.take();
    }
    if (!(neighbors.skin >= 0.0 && neighbors.skin <= max_skin)) {
        found.add({key(&NeighborSpec::skin)},
                  fmt::format("the skin is {}, allowed are 0 to {}", neighbors.skin, max_skin));
    }
    if (neighbors.every && *neighbors.every < 1) {
        found.add_of_key({key(&NeighborSpec::every)}, fmt::format("is {}, it must be at least 1", *neighbors.every));
    }
    if (neighbors.tile && *neighbors.tile < min_tile) {
        found.add_of_key({key(&NeighborSpec::tile)},
                         fmt::format("is {}, it must be at least {}", *neighbors.tile, min_tile));
    }
    const std::string meaningless = fmt::format("has no meaning for method = \"{}\"", neighbors.method);
    if (neighbors.tile && !neighbors.keeps_list()) {
        found.add_of_key({key(&NeighborSpec::tile), key(&NeighborSpec::method)}, meaningless, "only a list has tiles");
    }
    if (neighbors.every && !neighbors.keeps_list()) {
        found.add_of_key({key(&NeighborSpec::every), key(&NeighborSpec::method)}, meaningless,
                         "only a list is kept for some steps");
    }
    std::vector<Mistake> all = found.take();
    if (precision == Precision::mixed && !neighbors.keeps_list()) {
        Mistakes of_precision("performance");
        of_precision.add_of_key({"precision"},
                                fmt::format("is 'mixed', which method = \"{}\" does not have", neighbors.method),
                                fmt::format("{} has it", VerletList::name));
        of_precision.move_to(all);
    }
    return all;
}

std::vector<Mistake> cutoff_mistakes(double cutoff, const Box& box) {
    Mistakes found("potential");
    const double largest = 0.5 * box.shortest_edge();
    if (cutoff > largest) {
        found.add_of_key({potential_key(&PotentialTable::radius)},
                         fmt::format("is {}, more than half the box (L = {:.6g})", cutoff, box.shortest_edge()),
                         fmt::format("largest allowed: {}", largest));
    }
    return found.take();
}

/// Names of the analyses that take the box of each configuration.
std::string in_any_box() {
    std::vector<std::string> names;
    for (const AnalysisMethod& method : all_analyses()) {
        if (!method.needs.fixed_box) {
            names.push_back(method.name);
        }
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<Mistake> sampling_mistakes(const std::vector<Choice>& analyses, const std::vector<Stage>& stages) {
    if (analyses.empty()) {
        return {};
    }
    const bool follows_time =
        std::ranges::any_of(analyses, [](const Choice& analysis) { return find_analysis(analysis.name).follows_time; });
    const auto needs_box = std::ranges::find_if(
        analyses, [](const Choice& analysis) { return find_analysis(analysis.name).needs.fixed_box; });
    const std::size_t first = first_sampled(stages);
    const double time_step = stages[first].time_step;
    return judged(stages, [&](const Stage& stage, Mistakes& found) {
        const bool is_later = &stage >= &stages[first] && stages[first].sample;
        if (is_later && stage.barostat && needs_box != analyses.end()) {
            found.add(
                {key(&Stage::barostat)},
                fmt::format("'{}' needs a box that stays as it is from the first sampled stage on", needs_box->name),
                fmt::format("sample a later stage without barostat, or leave it out; with a barostat are: {}",
                            in_any_box()));
        }
        if (follows_time && stage.sample && stage.time_step != time_step) {
            found.add({key(&Stage::time_step)},
                      fmt::format("sampled stages have time steps of {} and {}, but analyses compare configurations at "
                                  "equal times apart",
                                  time_step, stage.time_step));
        }
    });
}

std::string step_in_words(const std::string& truncation) {
    return fmt::format(
        "truncation = \"{}\" has a step at the cutoff, whose impulses are missing in the forces; continuous are "
        "shifted, force-shifted and switched",
        truncation);
}

std::vector<Mistake> analysis_need_mistakes(const std::vector<Choice>& analyses, const std::string& truncation,
                                            const std::vector<Stage>& stages) {
    std::vector<Mistake> all;
    for (const Choice& analysis : analyses) {
        const AnalysisNeeds needs = find_analysis(analysis.name).needs;
        if (needs.continuous_potential && PairPotential::energy_jumps(truncation)) {
            Mistakes found("potential");
            found.add({potential_key(&PotentialTable::truncation)},
                      fmt::format("the analysis {} needs a continuous potential: {}", analysis.name,
                                  step_in_words(truncation)));
            found.move_to(all);
        }
        if (needs.constant_energy) {
            std::ranges::move(judged(stages,
                                     [&](const Stage& stage, Mistakes& found) {
                                         if (stage.sample && stage.thermostat) {
                                             found.add({type_key(&Stage::thermostat)},
                                                       fmt::format("the analysis {} needs sampled stages at constant "
                                                                   "energy: with a thermostat the pressure follows the "
                                                                   "energy that it gives and takes",
                                                                   analysis.name),
                                                       "let a stage with the thermostat come first, and sample one "
                                                       "without");
                                         }
                                     }),
                              std::back_inserter(all));
        }
    }
    return all;
}

std::vector<Mistake> analysis_mistakes(const std::vector<Choice>& analyses, const SampledRun& run) {
    std::vector<Mistake> all;
    for (const Choice& analysis : analyses) {
        Mistakes found("analysis", analysis.name);
        for (const auto& [key, message] : chosen_analysis(analysis).options->check(run)) {
            found.add({key}, message);
        }
        found.move_to(all);
    }
    return all;
}

std::vector<Mistake> box_mistakes(const FluidSpec& spec, Index atoms, const Box& box) {
    std::vector<Mistake> found = cutoff_mistakes(spec.potential.cutoff().radius, box);
    std::ranges::move(analysis_mistakes(spec.analyses, sampled_run(resolved_stages(spec), spec.seed, atoms, box)),
                      std::back_inserter(found));
    return found;
}

}  // namespace ljmd
