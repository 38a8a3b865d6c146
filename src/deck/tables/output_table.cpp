#include "deck/tables/output_table.hpp"

#include <fmt/format.h>

#include "io/formats/trajectory_writer.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/detail/options/table_description.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

namespace {

void describe_every(Description& description, TrajectoryOutput& trajectory) {
    description.required_integer("every", trajectory.every).at_least(1).meaning("steps between frames");
}

std::string in_words(Index every) {
    return every == 1 ? "every step" : fmt::format("every {} steps", every);
}

std::string in_words(const Interval& wall_time) {
    return fmt::format("every {:g} minutes", wall_time.seconds.value_or(0.0) / 60.0);
}

}  // namespace

FluidThermo::FluidThermo() : every(FluidSpec().sample_every) {}

void FluidThermo::describe(Description& description) {
    description.integer("every", every)
        .at_least(1)
        .meaning("steps between rows of thermo.csv, which are also the samples that averages are taken over");
}

void FewBodyThermo::describe(Description& description) {
    description.integer("every", every)
        .at_least(1)
        .meaning(
            "steps between rows of thermo.csv, from which the largest deviations in the results are taken; the end has "
            "a row, too");
}

void FluidTrajectory::describe(Description& description) {
    const std::vector<TrajectoryFormat> formats = all_trajectory_formats();
    description.choice("format", plugin_names(formats), format)
        .meaning("of the file trajectory.h5md and so on; " + meanings_of(formats));
    describe_every(description, *this);
    description.flag("velocities", velocities).meaning("write velocities too");
    description.flag("forces", forces).meaning("write the forces on the atoms too");
    description.flag("energies", energies)
        .meaning("write the energies of the atoms too, half of those of their pairs, without tail");
    description.choice("units", {"reduced", "si"}, units)
        .meaning(fmt::format("si ({}) needs [argon]", meanings_of(formats, &TrajectoryFormat::si_units)));
}

void FewBodyTrajectory::describe(Description& description) {
    const std::vector<TrajectoryFormat> formats = all_trajectory_formats();
    std::vector<std::string> names = plugin_names(formats);
    names.insert(names.begin(), "csv");
    description.choice("format", names, format)
        .meaning("of the file trajectory.csv and so on; csv: positions and velocities; " + meanings_of(formats));
    describe_every(description, *this);
    description.flag("velocities", velocities).meaning("write velocities too; csv always has them");
    description.flag("accelerations", accelerations).meaning("write accelerations too; csv only");
}

void CheckpointOutput::describe(Description& description) {
    description.interval("every", every)
        .at_least(1)
        .at_most(static_cast<double>(max_steps))
        .meaning("steps, or wall time");
    description.integer("keep", keep)
        .at_least(1)
        .at_most(9)
        .meaning("generations; with 2, a damaged one can be done without");
}

template <class Thermo, class Trajectory>
void OutputTable<Thermo, Trajectory>::describe(TableDescription& description) {
    description.text("directory", directory).optional("runs/ and the deck's name").meaning("where the results go");
    description.table("thermo", "thermo", thermo)
        .optional(in_words(thermo.every))
        .meaning("history of energies, thermo.csv");
    description.table("trajectory", "trajectory", trajectory).optional("none").meaning("positions against time");
    description.table("checkpoint", "checkpoint", checkpoint)
        .optional(in_words(checkpoint.every))
        .meaning(
            "what `ljmd resume` continues from; also written at the start, at the ends of stages, and when the run is "
            "stopped");
    description.flag("report", report)
        .meaning("write report.html at the end, as `ljmd report` does; done by `ljmd run` and `ljmd resume`");
}

template struct OutputTable<FluidThermo, FluidTrajectory>;
template struct OutputTable<FewBodyThermo, FewBodyTrajectory>;

}  // namespace ljmd
