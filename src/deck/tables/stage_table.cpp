#include "ljmd/deck/tables/stage_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ljmd/engine/until_mistakes.hpp"
#include "ljmd/input/deck_setting.hpp"
#include "ljmd/input/table_description.hpp"

namespace ljmd {

namespace {

void describe_beginning(TableDescription& description, StageTable& stage,
                        const std::vector<IntegratorMethod>& integrators) {
    description.required_text(element_name, stage.name)
        .meaning("for messages, results and `--set stage.NAME.key=value`; unique");
    description.plugin("integrator", integrators, stage.integrator)
        .meaning("integration scheme; " + meanings_of(integrators));
}

Key& describe_steps(TableDescription& description, StageTable& stage) {
    return description.required_integer("steps", stage.steps)
        .at_least(0)
        .at_most(static_cast<double>(max_steps))
        .meaning("number of steps; a run of 0 steps in all evaluates the start once");
}

void describe_reverse(TableDescription& description, StageTable& stage) {
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

}  // namespace

void ThermostatTable::describe(TableDescription& description) {
    const std::vector<ThermostatMethod> thermostats = all_thermostats();
    description.plugin("type", thermostats, method).meaning(meanings_of(thermostats));
}

void BarostatTable::describe(TableDescription& description) {
    const std::vector<BarostatMethod> barostats = all_barostats();
    description.plugin("type", barostats, method).meaning(meanings_of(barostats));
}

UntilTable::UntilTable() : errors(until_observables().size()) {}

void UntilTable::describe(TableDescription& description) {
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

void FluidStageTable::describe(TableDescription& description) {
    describe_beginning(description, *this, integrators_of_fluids());
    description.required_number("time_step", time_step)
        .dimension(Dimension::time)
        .unit("tau")
        .above(0.0)
        .meaning("below 0.02 unless --force is given");
    describe_steps(description, *this).optional("needed unless `until` is given");
    description.table("until", "until", until)
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
    description.table("thermostat", "thermostat", thermostat)
        .optional("none: constant energy")
        .meaning(meaning_of_thermostats());
    description.table("barostat", "barostat", barostat)
        .optional("none: constant volume")
        .meaning("holds the pressure, beside a canonical thermostat");
    description.flag("sample", sample).meaning("measure observables in this stage");
}

void FewBodyStageTable::describe(TableDescription& description) {
    describe_beginning(description, *this, all_integrators());
    description.required_number("time_step", time_step).above(0.0).meaning("in the deck's unit of time");
    describe_steps(description, *this);
    describe_reverse(description, *this);
    description.flag("sample", sample)
        .meaning("the analyses look at this stage; sampled stages follow one another, and none runs backwards");
}

}  // namespace ljmd
