#include "ljmd/engine/stage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/mistakes/until_mistakes.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "options/placed.hpp"

namespace ljmd {

namespace {

void describe_beginning(TableDescription& description, Stage& stage, const std::vector<IntegratorMethod>& integrators) {
    description.required_text("name", stage.name)
        .meaning("for messages, results and `--set stage.NAME.key=value`; unique");
    description.plugin("integrator", integrators, stage.integrator)
        .meaning("integration scheme; " + meanings_of(integrators));
}

Key& describe_steps(TableDescription& description, Stage& stage) {
    return description.required_integer("steps", stage.steps)
        .at_least(0)
        .at_most(static_cast<double>(max_steps))
        .meaning("number of steps; a run of 0 steps in all evaluates the start once");
}

void describe_reverse(TableDescription& description, Stage& stage) {
    description.flag("reverse", stage.reverse)
        .meaning("turn the motion round before the first step: a reversible integrator then goes back the way it came");
}

std::vector<IntegratorMethod> integrators_of_fluids() {
    std::vector<IntegratorMethod> integrators = all_integrators();
    std::erase_if(integrators, [](const IntegratorMethod& method) { return method.unbounded_only; });
    return integrators;
}

std::string meaning_of_thermostats() {
    std::vector<std::string> others;
    for (const ThermostatMethod& method : all_thermostats()) {
        if (!method.every_step) {
            others.push_back(fmt::format("`{}`", method.name));
        }
    }
    return fmt::format("holds the temperature; all but {} go with velocity-verlet only", fmt::join(others, ", "));
}

/// `until`: the errors that end a stage, by the names of their observables, and its largest number of steps.
struct UntilTable {
    std::vector<std::optional<double>> errors = std::vector<std::optional<double>>(until_observables().size());
    Index max_steps = 0;

    void describe(Description& description) {
        for (std::size_t k = 0; k < errors.size(); ++k) {
            const UntilObservable& observable = until_observables()[k];
            description.number(observable.name, errors[k])
                .dimension(observable.dimension)
                .unit(observable.unit)
                .above(0.0)
                .optional("not waited for")
                .meaning(fmt::format("largest standard error of the mean of {}", observable.name));
        }
        description.required_integer("max_steps", max_steps)
            .at_least(1)
            .at_most(static_cast<double>(ljmd::max_steps))
            .meaning("the stage ends after so many steps even if the errors are larger, with a warning");
    }
};

void take_until(Stage& stage, const UntilTable& table) {
    stage.steps = table.max_steps;
    for (std::size_t k = 0; k < table.errors.size(); ++k) {
        if (table.errors[k]) {
            stage.until.push_back({until_observables()[k].name, *table.errors[k]});
        }
    }
}

std::optional<UntilTable> until_of(const Stage& stage) {
    if (stage.until.empty()) {
        return std::nullopt;
    }
    UntilTable table;
    table.max_steps = stage.steps;
    for (const WantedError& wanted : stage.until) {
        const auto& known = until_observables();
        const auto observable = std::ranges::find(known, wanted.observable, &UntilObservable::name);
        if (observable != known.end()) {
            table.errors[static_cast<std::size_t>(observable - known.begin())] = wanted.error;
        }
    }
    return table;
}

}  // namespace

void Stage::describe(TableDescription& description) {
    describe_beginning(description, *this, integrators_of_fluids());
    description.required_number("time_step", time_step)
        .dimension(Dimension::time)
        .unit("tau")
        .above(0.0)
        .meaning("below 0.02 unless --force is given");
    describe_steps(description, *this).optional("needed unless `until` is given");
    description
        .table_for<UntilTable>(
            "until", &until, [this](const UntilTable& table) { take_until(*this, table); },
            [this] { return until_of(*this); })
        .optional("as many steps as `steps` says")
        .meaning(
            "in place of `steps` in the last stage, which is sampled: it ends as soon as the averages have these "
            "standard errors, `{ pressure = 0.005, max_steps = 1000000 }`");
    describe_reverse(description, *this);
    description.number("temperature", temperature)
        .dimension(Dimension::temperature)
        .unit("epsilon/k_B")
        .at_least(0.0)
        .optional("that of [system]")
        .meaning("what the thermostat holds in this stage");
    description.number("total_energy", total_energy)
        .dimension(Dimension::energy)
        .unit("epsilon")
        .optional("as the atoms come")
        .meaning(
            "(U + K)/N, tail included, to which velocities are scaled before the first step; only without a "
            "thermostat");
    description.plugin_table("thermostat", all_thermostats(), thermostat)
        .optional("none: constant energy")
        .meaning(meaning_of_thermostats());
    description.plugin_table("barostat", all_barostats(), barostat)
        .optional("none: constant volume")
        .meaning("holds the pressure, beside a canonical thermostat");
    description.flag("sample", sample).meaning("measure observables in this stage");
}

void Stage::describe_few_body(TableDescription& description) {
    describe_beginning(description, *this, all_integrators());
    description.required_number("time_step", time_step).above(0.0).meaning("in the deck's unit of time");
    describe_steps(description, *this);
    describe_reverse(description, *this);
    description.flag("sample", sample)
        .meaning("the analyses look at this stage; sampled stages follow one another, and none runs backwards");
}

Stage completed(Stage stage) {
    stage.integrator = choice_of(chosen_integrator(stage.integrator));
    if (stage.thermostat) {
        stage.thermostat = choice_of(chosen_thermostat(*stage.thermostat));
    }
    if (stage.barostat) {
        stage.barostat = choice_of(chosen_barostat(*stage.barostat));
    }
    return stage;
}

std::optional<double> held_pressure(const Stage& stage) {
    return stage.barostat ? std::optional(chosen_barostat(*stage.barostat).options->held_pressure()) : std::nullopt;
}

bool conserves_energy(const Stage& stage) {
    return !stage.barostat && (!stage.thermostat || find_thermostat(stage.thermostat->name).canonical);
}

Index total_steps(const std::vector<Stage>& stages) {
    return steps_before(stages, stages.size());
}

Index steps_before(const std::vector<Stage>& stages, std::size_t index) {
    Index sum = 0;
    for (std::size_t k = 0; k < index; ++k) {
        sum += stages[k].steps;
    }
    return sum;
}

std::size_t first_sampled(const std::vector<Stage>& stages) {
    if (stages.empty()) {
        throw InputError("a run has at least one stage");
    }
    const auto first = std::ranges::find_if(stages, &Stage::sample);
    return static_cast<std::size_t>((first == stages.end() ? first - 1 : first) - stages.begin());
}

}  // namespace ljmd
