#include "ljmd/run/run_in_directory.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>

#include "deck/deck_system.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "ljmd/core/errors.hpp"
#include "run/given/given_record.hpp"
#include "run/held_run.hpp"
#include "run/run.hpp"
#include "run/run_directory.hpp"
#include "run/run_lock.hpp"
#include "run/spec_plan.hpp"

namespace ljmd {

namespace {

constexpr const char* language = "C++";

/// Passes on what it hears, and keeps the warnings for the results.
class Relay : public RunListener {
  public:
    explicit Relay(RunListener* listener) : listener_(listener) {}

    void stage_begins(const Stage& stage) override {
        if (listener_ != nullptr) {
            listener_->stage_begins(stage);
        }
    }
    void step_done(Index step) override {
        if (listener_ != nullptr) {
            listener_->step_done(step);
        }
    }
    void errors(const std::vector<ErrorSoFar>& errors) override {
        if (listener_ != nullptr) {
            listener_->errors(errors);
        }
    }
    void warning(const std::string& text) override {
        warnings.push_back(text);
        if (listener_ != nullptr) {
            listener_->warning(text);
        }
    }

    std::vector<std::string> warnings;

  private:
    RunListener* listener_;
};

/// Write the configuration that a run starts from, so that one that reads it starts from the same bits.
void keep(const Configuration& given, const Box& box, const OutputPlace& place) {
    State state(static_cast<Index>(given.positions.size()), box);
    place_configuration(state, given);
    write_configuration(place, state, !given.velocities.empty());
}

}  // namespace

RunResult run_in_directory(const FluidSpec& spec, const std::filesystem::path& directory,
                           const DirectoryOptions& options, const Execution& execution) {
    if (directory.empty()) {
        throw InputError("the name of the directory is empty");
    }
    Relay relay(options.listener);
    const auto warn = [&relay](const std::string& text) { relay.warning(text); };
    RunPlan plan = plan_of(spec, options.files, execution.precision(), directory / given_start_name);
    plan.directory = directory;
    plan.given = {.by = language, .observers = records_of(options.observers), .external = name_of(spec.external)};
    if (spec.potential.is_custom()) {
        plan.given.potential = given_potential(spec.potential);
    }
    check_directory(plan, options.replace);
    // Made before any file is touched: if this fails, an earlier run must not be lost.
    FluidSpec planned = fluid_spec(plan);
    planned.external = spec.external;
    FluidSystem fluid = make_fluid(planned, execution, warn);
    RunLock lock(plan, options.replace, warn);
    if (const auto* given = std::get_if<Configuration>(&spec.start)) {
        keep(*given, box_of(spec), plan.outputs() / given_start_name);
    }
    const RunControl control{.interruption = options.interruption,
                             .has_begun = [&lock] { lock.has_begun(); },
                             .observers = options.observers};
    RunResult result = lock.run([&] { return run_plan(plan, fluid, relay, control); });
    lock.warn_if_moved();
    result.warnings = relay.warnings;
    return result;
}

RunResult resume_in_directory(const std::filesystem::path& directory, const ResumedDirectoryOptions& options) {
    if (options.more_steps < 0 || options.threads < 0) {
        throw InputError(
            fmt::format("{} more steps, {} threads: allowed are 0 and more", options.more_steps, options.threads));
    }
    Relay relay(options.listener);
    HeldRun run(
        directory, options.more_steps, options.threads, [&relay](const std::string& text) { relay.warning(text); },
        {.by = language, .potential = options.potential, .observers = options.observers, .external = options.external});
    require_fluid(run.deck(), fmt::format("{} holds a run of few bodies, not of a fluid", directory.string()));
    for (const std::string& warning : run.warnings()) {
        relay.warning(warning);
    }
    AnySystem system =
        empty_system(run.deck(), run.checkpoint().atoms, run.checkpoint().edges, run.execution(), options.external);
    auto& fluid = std::get<FluidSystem>(system);
    const RunControl control{
        .interruption = options.interruption, .continuation = run.take(), .observers = options.observers};
    RunResult result = run_plan(run.deck(), fluid, relay, control);
    run.warn_if_moved();
    result.warnings = relay.warnings;
    return result;
}

}  // namespace ljmd
