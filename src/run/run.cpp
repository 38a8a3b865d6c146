#include "run/run.hpp"

#include "deck/fluid.hpp"
#include "engine/fluid_measurement.hpp"
#include "ljmd/core/errors.hpp"
#include "model/atoms_by_id.hpp"
#include "run/outputs/directory_outputs.hpp"
#include "run/outputs/shared_outputs.hpp"
#include "run/results.hpp"
#include "run/run_lock.hpp"

namespace ljmd {

namespace {

/// Call `work`, and save the configuration if the run fails.
template <class Work>
auto saving_failure(const RunPlan& plan, State& state, const Work& work) {
    try {
        return work();
    } catch (const PhysicsError& error) {
        state.finish_kick();
        std::string saved;
        look_by_id(state, [&] { saved = save_failure(plan, state); });
        throw PhysicsError(error.what() + saved);
    }
}

std::optional<UntilEnd> until_end(const RunResult& result) {
    const StageResult& last = result.stages.back();
    return last.until ? std::optional(UntilEnd{last.until->reached, last.last_step}) : std::nullopt;
}

}  // namespace

RunResult run_plan(const RunPlan& plan, FluidSystem& fluid, RunListener& listener, const RunControl& control) {
    FluidSpec spec = fluid_spec(plan);
    spec.external = fluid.force_field.external();
    // Of several ranks, rank 0 has the files.
    Ranks& ranks = fluid.state.execution().ranks();
    std::optional<DirectoryOutputs> directory;
    if (ranks.is_root()) {
        directory.emplace(plan, listener, control);
    }
    SharedOutputs outputs(plan, ranks, directory ? &*directory : nullptr);
    FluidMeasurement measurement(spec, fluid, outputs, control.observers);
    const auto from = restored(plan, control.continuation, measurement, fluid.state);
    look_by_id(fluid.state, [&] { directory->begin(fluid, from); });
    const LoopPosition end = saving_failure(plan, fluid.state, [&] {
        return run_stages(spec.stages, fluid.state, fluid.force_field, measurement.party(), from, spec.interaction());
    });
    RunResult result = measurement.result(end.seconds);
    for (const std::string& warning : result.warnings) {
        listener.doubted(warning);
    }
    look_by_id(fluid.state, [&] {
        directory->files().finish(fluid.state, {.report = results_report(plan, result),
                                                .tables = result.tables,
                                                .seconds = result.seconds.sum(),
                                                .phases = result.seconds,
                                                .until = until_end(result)});
    });
    return result;
}

FewBodyResult run_plan(const RunPlan& plan, FewBodySystem& system, RunListener& listener, const RunControl& control) {
    DirectoryOutputs outputs(plan, listener, control);
    FewBodyMeasurement measurement(plan.stages(), plan.sample_every(), system, outputs);
    const auto from = restored(plan, control.continuation, measurement, system.state);
    outputs.begin(system, from);
    const LoopPosition end = saving_failure(plan, system.state, [&] {
        const LoopPosition last =
            run_stages(plan.stages(), system.state, *system.force_field, measurement.party(), from);
        measurement.record_end();
        return last;
    });
    FewBodyResult result = measurement.result(end.seconds);
    outputs.files().finish(
        system.state, {.report = results_report(plan, result), .tables = result.tables, .seconds = result.seconds});
    return result;
}

Document run_plan(const RunPlan& plan, AnySystem& system, RunListener& listener, const RunControl& control) {
    return std::visit([&](auto& each) { return results_report(plan, run_plan(plan, each, listener, control)); },
                      system);
}

Document run_in_locked_directory(RunPlan& plan, AnySystem& system, bool replace, RunListener& listener,
                                 RunControl control) {
    RunLock lock(plan, replace, [&listener](const std::string& text) { listener.warning(text); });
    control.has_begun = [&lock] { lock.has_begun(); };
    Document report = lock.run([&] { return run_plan(plan, system, listener, control); });
    lock.warn_if_moved();
    return report;
}

}  // namespace ljmd
