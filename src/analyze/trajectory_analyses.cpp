#include "analyze/trajectory_analyses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.hpp"
#include "deck/fluid.hpp"
#include "deck/tables/fluid_tables.hpp"
#include "engine/mistakes/mistakes.hpp"
#include "input/deck_file.hpp"
#include "input/deck_setting.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "model/box_for_cutoff.hpp"
#include "options/words_elsewhere.hpp"

namespace ljmd {

namespace {

const std::string& analysis_table() {
    return Placed<FluidTables>::key(&FluidTables::analysis);
}

/// The [analysis] of a deck as written, with its settings; empty if it has none.
Table written_analysis(const Deck& deck) {
    Diagnostics none;  // the deck was checked before
    DeckFile file = parse_deck(deck.path, deck.source, none);
    for (const std::string& setting : deck.settings) {
        apply_setting(file.table, setting, none);
    }
    const Entry* entry = find(file.table, analysis_table());
    return entry != nullptr ? std::get<Table>(entry->value.data) : Table{};
}

/// The key of an analysis that says how many steps are between configurations.
Key step_interval_of(const AnalysisMethod& method) {
    const std::vector<Key> keys = keys_of(method);
    return *std::ranges::find_if(keys, &Key::is_step_interval);
}

/// The tables of these analyses, with `every` converted to frames.
Table tables_of(const std::vector<AnalysisMethod>& methods, const Deck* deck, std::optional<Index> steps_apart) {
    Table written = deck != nullptr ? written_analysis(*deck) : Table{};
    Table tables;
    for (const AnalysisMethod& method : methods) {
        Entry* entry = find(written, method.name);
        Table table = entry != nullptr ? std::get<Table>(entry->value.data) : Table{};
        const Key key = step_interval_of(method);
        const Entry* every = find(table, key.name);
        const Index usual = entry != nullptr ? std::get<std::int64_t>(*key.default_value) : 1;
        const Index steps = every != nullptr ? std::get<std::int64_t>(every->value.data) : usual;
        const std::int64_t frames = std::max<Index>(steps / steps_apart.value_or(steps), 1);
        std::erase_if(table, [&key](const Entry& e) { return e.key == key.name; });
        table.push_back({key.name, {}, Value{frames, {}}});
        tables.push_back({method.name, {}, Value{table, {}}});
    }
    return tables;
}

/// Apply the settings of the command line.
Table with_settings(Table tables, const std::vector<std::string>& settings, const std::vector<std::string>& names) {
    Table root;
    root.push_back({analysis_table(), {}, Value{std::move(tables), {}}});
    Diagnostics diagnostics;
    for (const std::string& setting : settings) {
        const bool meant = std::ranges::any_of(names, [&](const std::string& name) {
            return setting.starts_with(fmt::format("{}.{}.", analysis_table(), name));
        });
        if (names.empty()) {
            throw InputError(fmt::format("--set {}: thermo has no settings", setting));
        }
        if (!meant) {
            throw InputError(fmt::format("--set {}: only settings of what is measured can be given, {}.{}.KEY=VALUE",
                                         setting, analysis_table(),
                                         fmt::join(names, fmt::format(".KEY=VALUE, {}.", analysis_table()))));
        }
        apply_setting(root, setting, diagnostics);
    }
    diagnostics.throw_if_errors();
    return std::get<Table>(root.front().value.data);
}

/// The run that the trajectory represents; its steps are frames.
SampledRun run_of(const Deck* deck, const TrajectorySummary& trajectory, const FrameSelection& selection) {
    Box box(trajectory.smallest_edges);
    if (deck != nullptr) {
        box = box_for_cutoff(box, deck->potential().radius);
    }
    SampledRun run = deck != nullptr ? sampled_run(*deck, trajectory.atoms, box)
                                     : SampledRun{trajectory.atoms, box, 1.0, 0, 1, std::nullopt, std::nullopt};
    run.is_film = deck != nullptr && deck->system().is_film();
    run.time_step = selection.spacing.value_or(1.0);
    run.steps = selection.longest_part;
    if (deck != nullptr && (!deck->given.potential || deck->given.potential->potential)) {
        run.interaction = fluid_spec(*deck).interaction();
    }
    return run;
}

/// Why an analysis of a trajectory is impossible; empty if it is possible.
std::string obstacle(const AnalysisMethod& method, const Deck* deck, const SampledRun& run,
                     const TrajectorySummary& trajectory, const FrameSelection& selection) {
    const AnalysisNeeds& needs = method.needs;
    if (needs.velocities && !trajectory.has_velocities) {
        return fmt::format("needs velocities, {}", trajectory.missing_velocities);
    }
    if (needs.unwrapped_positions && !trajectory.positions.positions) {
        return fmt::format("needs displacements: {}", trajectory.positions.reason);
    }
    if (method.follows_time && !selection.spacing) {
        return fmt::format("needs equally spaced frames: {}", selection.uneven);
    }
    if (method.follows_time && trajectory.is_part) {
        return fmt::format("needs all atoms: {}", part_of_the_atoms);
    }
    if (needs.fixed_box && trajectory.box_changes) {
        return fmt::format("needs a box that stays the same, but that of frame {} is another one than that of frame 1",
                           *trajectory.box_changes);
    }
    if (needs.interaction && deck != nullptr && !deck->given.external.empty()) {
        return fmt::format("is for a homogeneous fluid, and the external force {} acted on this one",
                           in_quotes(deck->given.external));
    }
    if (needs.homogeneous && run.is_film) {
        return "is for a homogeneous fluid, and the box of this deck is higher than the crystal of its start: it is a "
               "film";
    }
    if (needs.interaction && !run.interaction) {
        return deck != nullptr ? fmt::format("needs the interaction: {}", deck->given.potential->missing)
                               : "needs the interaction: give a deck with --deck";
    }
    if (const double largest = 0.5 * run.box.shortest_edge();
        needs.interaction && run.interaction->potential.cutoff().radius > largest) {
        return fmt::format("needs the interaction, but the cutoff of the deck, {}, is more than half the box, {:.6g}",
                           run.interaction->potential.cutoff().radius, largest);
    }
    if (needs.continuous_potential && PairPotential::energy_jumps(run.interaction->potential.truncation())) {
        return fmt::format("needs a continuous potential: {}", step_in_words(run.interaction->potential.truncation()));
    }
    if (needs.constant_energy && run.held_temperature) {
        return "needs frames at constant energy, and the deck holds the temperature with a thermostat while it samples";
    }
    return "";
}

}  // namespace

std::vector<std::string> default_analyses(const TrajectorySummary& trajectory, const FrameSelection& selection) {
    std::vector<std::string> names{"rdf"};
    if (!trajectory.box_changes) {
        names.emplace_back("structure_factor");
        if (selection.spacing && trajectory.positions.positions && !trajectory.is_part) {
            names.emplace_back("msd");
        }
    }
    return names;
}

void check_thermo(const Deck* deck, const TrajectorySummary& trajectory, const FrameSelection& selection) {
    AnalysisMethod method;
    method.needs = {.velocities = true, .interaction = true, .fixed_box = false};
    if (const std::string reason = obstacle(method, deck, run_of(deck, trajectory, selection), trajectory, selection);
        !reason.empty()) {
        throw InputError(fmt::format("thermo {}", reason));
    }
}

void check_analysis_names(const std::vector<std::string>& names) {
    std::vector<std::string> allowed = plugin_names(all_analyses());
    allowed.emplace_back("thermo");
    for (const std::string& name : names) {
        if (std::ranges::find(allowed, name) == allowed.end()) {
            std::string hint = word_elsewhere(name);
            if (const std::string nearest = nearest_name(name, allowed); hint.empty()) {
                hint = nearest.empty() ? fmt::format("allowed: {}", fmt::join(allowed, ", "))
                                       : fmt::format("did you mean '{}'?", nearest);
            }
            throw InputError(fmt::format("unknown analysis {}\n  {}", in_quotes(name), hint));
        }
    }
}

std::vector<FrameAnalysis> make_frame_analyses(const std::vector<std::string>& names,
                                               const std::vector<std::string>& settings, const Deck* deck,
                                               const TrajectorySummary& trajectory, const FrameSelection& selection) {
    const SampledRun run = run_of(deck, trajectory, selection);
    std::vector<AnalysisMethod> methods;
    Schema schema("[analysis]");
    for (const std::string& name : names) {
        const AnalysisMethod& method = methods.emplace_back(find_plugin(all_analyses(), name, "analysis"));
        if (const std::string reason = obstacle(method, deck, run, trajectory, selection); !reason.empty()) {
            throw InputError(fmt::format("{} {}", name, reason));
        }
        schema = schema.with({Key::table(name, Schema(name, keys_of(method)))});
    }
    const Table table = with_settings(tables_of(methods, deck, selection.steps_apart), settings, names);
    Diagnostics diagnostics;
    const Section sections = validate(table, {}, schema, deck != nullptr ? deck->units() : std::nullopt, diagnostics);
    for (const AnalysisMethod& method : methods) {
        const Section& section = sections.section(method.name);
        report_at_keys(choose(method, section).options->check(run), section, diagnostics);
    }
    diagnostics.throw_if_errors();
    std::vector<FrameAnalysis> analyses;
    analyses.reserve(methods.size());
    for (const AnalysisMethod& method : methods) {
        analyses.push_back({method, choose(method, sections.section(method.name)).options->make(run)});
    }
    return analyses;
}

}  // namespace ljmd
