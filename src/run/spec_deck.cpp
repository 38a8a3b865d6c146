#include "ljmd/run/spec_deck.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <type_traits>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_schema.hpp"
#include "ljmd/input/toml_text.hpp"

namespace ljmd {

namespace {

/// A value as TOML. Numbers are written with as many digits as tell them from others.
std::string toml(const PlainValue& value) {
    return std::visit(
        [](const auto& any) -> std::string {
            using T = std::remove_cvref_t<decltype(any)>;
            if constexpr (std::is_same_v<T, std::string>) {
                return toml_string(any);
            } else if constexpr (std::is_same_v<T, std::vector<double>>) {
                return fmt::format("[{}]", fmt::join(any, ", "));
            } else {
                return fmt::format("{}", any);
            }
        },
        value);
}

/// "key = value" of all settings, with this between them.
std::string toml(const Settings& settings, std::string_view between) {
    std::string text;
    for (const auto& [key, value] : settings) {
        text += fmt::format("{}{} = {}", text.empty() ? "" : between, key, toml(value));
    }
    return text;
}

std::string inline_table(const Settings& settings) {
    return settings.empty() ? "{}" : fmt::format("{{ {} }}", toml(settings, ", "));
}

std::string lines(const Settings& settings) {
    return settings.empty() ? "" : toml(settings, "\n") + "\n";
}

/// A plug-in with its options, as the table that chooses it by its `type`.
template <class Chosen>
std::string table_of(const Chosen& chosen) {
    Settings settings{{"type", chosen.plugin.name}};
    settings.insert(settings.end(), chosen.values.begin(), chosen.values.end());
    return inline_table(settings);
}

std::string lattice_name(Lattice lattice) {
    const std::vector<std::string> names = lattice_names();
    return *std::ranges::find(names, lattice, find_lattice);
}

/// Why no deck says the same; empty if one can.
std::string not_for_decks(const FluidSpec& spec) {
    if (spec.potential.is_custom()) {
        return fmt::format("potential: '{}' is a formula of the program, which no deck can name",
                           spec.potential.formula());
    }
    if (spec.external) {
        return fmt::format("external: '{}' is a force of the program, which no deck can name", spec.external->name());
    }
    if (spec.seed > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
        return fmt::format("seed: a deck has one below 2^63, found {}", spec.seed);
    }
    for (const Stage& stage : spec.stages) {
        if (stage.seed != 0 && stage.seed != spec.seed) {
            return fmt::format("stage '{}': in a deck all stages have the seed of the start", stage.name);
        }
    }
    return {};
}

std::string substance_text(const SubstanceUnits& units) {
    return fmt::format("\n[argon]\nsigma = \"{} m\"\nepsilon = \"{} J\"\nmass = \"{} kg\"\n",
                       units.si(Dimension::length), units.si(Dimension::energy), units.si(Dimension::mass));
}

std::string system_text(const FluidSpec& spec, const std::filesystem::path& start) {
    Settings settings;
    std::string text = "\n[system]\n";
    if (const auto* crystal = std::get_if<LatticeStart>(&spec.start)) {
        Settings lattice{{"type", lattice_name(crystal->lattice)}, {"cells", std::int64_t{crystal->cells}}};
        if (crystal->layers) {
            lattice.emplace_back("layers", std::int64_t{*crystal->layers});
        }
        if (crystal->height) {
            lattice.emplace_back("height", *crystal->height);
        }
        text += fmt::format("lattice = {}\n", inline_table(lattice));
    } else if (const auto* random = std::get_if<RandomStart>(&spec.start)) {
        text +=
            fmt::format("lattice = {}\n", inline_table({{"type", "random"}, {"atoms", std::int64_t{random->atoms}}}));
    }
    if (std::holds_alternative<Configuration>(spec.start)) {
        settings.emplace_back("file", start.string());
        if (!spec.keep_velocities) {
            settings.emplace_back("velocities", "maxwell");
        }
    } else {
        settings.emplace_back("density", spec.density);
    }
    if (spec.temperature) {
        settings.emplace_back("temperature", *spec.temperature);
    }
    settings.emplace_back("seed", static_cast<std::int64_t>(spec.seed));
    return text + lines(settings);
}

std::string potential_text(const FluidSpec& spec) {
    const PairPotential& potential = spec.potential;
    Settings settings{
        {"type", potential.formula()}, {"cutoff", potential.cutoff().radius}, {"truncation", potential.truncation()}};
    Cutoff cutoff = potential.cutoff();
    Description description;
    PairPotential::describe_truncation(potential.truncation(), description, cutoff);
    const Settings of_truncation = description.values();
    settings.insert(settings.end(), of_truncation.begin(), of_truncation.end());
    if (PairPotential::takes_tail(potential.truncation())) {
        settings.emplace_back("tail", spec.tail);
    }
    settings.insert(settings.end(), potential.parameters().begin(), potential.parameters().end());
    return "\n[potential]\n" + lines(settings);
}

std::string neighbors_text(const NeighborSpec& neighbors) {
    Settings settings{{"method", neighbors.method}, {"skin", neighbors.skin}};
    if (neighbors.every) {
        settings.emplace_back("every", std::int64_t{*neighbors.every});
    }
    if (neighbors.tile) {
        settings.emplace_back("tile", std::int64_t{*neighbors.tile});
    }
    return "\n[neighbors]\n" + lines(settings);
}

std::string stage_text(const Stage& stage) {
    Settings settings{{"name", stage.name}, {"integrator", stage.integrator.plugin.name}};
    settings.insert(settings.end(), stage.integrator.values.begin(), stage.integrator.values.end());
    settings.emplace_back("time_step", stage.time_step);
    if (stage.until.empty()) {
        settings.emplace_back("steps", std::int64_t{stage.steps});
    }
    if (stage.total_energy) {
        settings.emplace_back("total_energy", *stage.total_energy);
    }
    if (stage.thermostat) {
        settings.emplace_back("temperature", stage.temperature);
    }
    settings.emplace_back("sample", stage.sample);
    settings.emplace_back("reverse", stage.reverse);
    std::string text = "\n[[stage]]\n" + lines(settings);
    if (stage.thermostat) {
        text += fmt::format("thermostat = {}\n", table_of(*stage.thermostat));
    }
    if (!stage.until.empty()) {
        Settings until;
        for (const WantedError& wanted : stage.until) {
            until.emplace_back(wanted.observable, wanted.error);
        }
        until.emplace_back("max_steps", std::int64_t{stage.steps});
        text += fmt::format("until = {}\n", inline_table(until));
    }
    if (stage.barostat) {
        text += fmt::format("barostat = {}\n", table_of(*stage.barostat));
    }
    return text;
}

std::string output_text(const FluidSpec& spec, const RunFiles& files) {
    std::string text =
        fmt::format("\n[output]\nthermo = {}\n", inline_table({{"every", std::int64_t{spec.sample_every}}}));
    if (files.trajectory) {
        const TrajectoryOutput& trajectory = *files.trajectory;
        text += fmt::format("trajectory = {}\n", inline_table({{"format", trajectory.format},
                                                               {"every", std::int64_t{trajectory.every}},
                                                               {"velocities", trajectory.velocities},
                                                               {"forces", trajectory.forces},
                                                               {"energies", trajectory.energies},
                                                               {"units", trajectory.units}}));
    }
    const Interval& every = files.checkpoint.every;
    if (every.steps.has_value() == every.seconds.has_value()) {
        throw InputError("checkpoint: 'every' is a number of steps or of seconds, one of both");
    }
    const PlainValue interval =
        every.steps ? PlainValue(std::int64_t{*every.steps}) : PlainValue(fmt::format("{} s", *every.seconds));
    return text + fmt::format("checkpoint = {}\n",
                              inline_table({{"every", interval}, {"keep", std::int64_t{files.checkpoint.keep}}}));
}

}  // namespace

std::string deck_text(const FluidSpec& spec, const RunFiles& files, Precision precision,
                      const std::filesystem::path& start) {
    require_no_mistakes(spec, precision);
    if (const std::string why = not_for_decks(spec); !why.empty()) {
        throw InputError(why);
    }
    std::string text = lines({{"title", files.title}});
    text += spec.units ? substance_text(*spec.units) : "";
    text += system_text(spec, start) + potential_text(spec) + neighbors_text(spec.neighbors);
    text += "\n[performance]\n" + lines({{"precision", std::string(name(precision))}});
    for (const Stage& stage : spec.stages) {
        text += stage_text(stage);
    }
    text += output_text(spec, files);
    text += spec.analyses.empty() ? "" : "\n[analysis]\n";
    for (const ChosenAnalysis& analysis : spec.analyses) {
        text += fmt::format("{} = {}\n", analysis.plugin.name, inline_table(analysis.values));
    }
    return text;
}

}  // namespace ljmd
