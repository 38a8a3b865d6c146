#include "ljmd/app/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "ljmd/app/results.hpp"
#include "ljmd/app/run_directory.hpp"
#include "ljmd/app/stability.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/schedule.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/thermostat.hpp"
#include "ljmd/observables/linear_trend.hpp"

namespace ljmd {

namespace {

/// Sampling a liquid while this much of the crystal is left measures neither.
constexpr double crystal_left = 0.1;

/// Fewer independent samples than this do not carry an error bar.
constexpr double few_samples = 16.0;

/// Steps between looks at the atoms' speeds; looking costs a hundredth of a step.
constexpr Index steps_between_looks = 10;

/// The time loop of one run: integrates, samples and writes.
class Loop {
  public:
    Loop(const Deck& deck, Simulation& simulation, RunListener& listener)
        : deck_(deck),
          simulation_(simulation),
          listener_(listener),
          thermo_every_(deck.thermo_every),
          files_(deck, simulation.state, simulation.order.has_value()),
          averages_(simulation.state.count(), density()) {}

    RunResult run() {
        try {
            return run_all();
        } catch (const PhysicsError& error) {
            const std::string stage = stage_.empty() ? "" : fmt::format(" (stage '{}')", stage_);
            throw PhysicsError(fmt::format("step {}{}: {}{}", step_, stage, error.what(), save_failure()));
        }
    }

  private:
    RunResult run_all() {
        const auto began = std::chrono::steady_clock::now();
        evaluation_ = simulation_.force_field.evaluate(simulation_.state, Request::forces_and_energy);
        files_.write_frame(simulation_.state);
        write_thermo(current());
        if (deck_.total_steps() == 0) {
            averages_.add(current());
            sample_analyses(true);
        }
        for (const Stage& stage : deck_.stages) {
            run_stage(stage);
        }
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
        return finish(took.count());
    }

    [[nodiscard]] double density() const {
        return static_cast<double>(simulation_.state.count()) / simulation_.state.box().volume();
    }

    [[nodiscard]] Thermodynamics current() const {
        return thermodynamics(simulation_.state, evaluation_, simulation_.tail);
    }

    [[nodiscard]] std::optional<double> order() const {
        return simulation_.order ? std::optional((*simulation_.order)(simulation_.state)) : std::nullopt;
    }

    /// Write the state of a failed step. Its positions and velocities may belong to no one time, but they show where it
    /// went wrong. @return what to tell the user of it
    [[nodiscard]] std::string save_failure() const {
        try {
            return fmt::format("\n  the configuration is in {}", files_.write_failed(simulation_.state).string());
        } catch (const FileError&) {
            return {};  // the failure itself is what matters
        }
    }

    void write_thermo(const Thermodynamics& row) {
        files_.write_thermo(simulation_.state.step, simulation_.state.time, row, order());
    }

    void sample_analyses(bool always) {
        for (const auto& analysis : simulation_.analyses) {
            if (always || analysis->due(simulation_.state.step)) {
                analysis->sample(simulation_.state);
            }
        }
    }

    void begin_sampling() {
        if (!order_at_sampling_) {
            order_at_sampling_ = order();
        }
    }

    void run_stage(const Stage& stage) {
        listener_.stage_begins(stage);
        stage_ = stage.name;
        State& state = simulation_.state;
        const Integrator integrator(find_integrator(stage.integrator), stage.time_step, stage.section);
        std::unique_ptr<Thermostat> thermostat;
        if (stage.section.has("thermostat")) {
            const Section& section = stage.section.section("thermostat");
            thermostat = find_thermostat(section.text("type")).make(section, stage.temperature);
        }
        if (stage.sample && stage.steps > 0) {
            begin_sampling();
        }
        StabilityWatch watch(stage.time_step, thermostat == nullptr, simulation_.force_field.potential());
        LinearTrend drift;
        const Index first_step = state.step;
        const double first_time = state.time;
        for (Index n = 1; n <= stage.steps; ++n) {
            step_ = first_step + n;
            const bool thermo_due = thermo_every_.due(step_);
            evaluation_ = integrator.step(state, simulation_.force_field,
                                          thermo_due ? Request::forces_and_energy : Request::forces);
            state.step = step_;
            state.time = first_time + static_cast<double>(n) * stage.time_step;
            if (n % steps_between_looks == 0) {
                watch.check_speeds(state);
            }
            if (thermostat) {
                thermostat->apply(state, n);
            }
            if (thermo_due) {
                const Thermodynamics row = current();
                write_thermo(row);
                watch.check_energy(row);
                drift.add(state.time, row.total_energy);
                if (stage.sample) {
                    averages_.add(row);
                }
            }
            if (stage.sample) {
                sample_analyses(false);
            }
            files_.write_frame_if_due(state);
            listener_.step_done(step_);
        }
        stages_.push_back({stage.name, stage.integrator, first_step, state.step, stage.time_step, stage.sample,
                           thermostat != nullptr, thermostat ? std::nullopt : drift.slope()});
    }

    RunResult finish(double seconds) {
        const State& state = simulation_.state;
        RunResult result{state.count(),
                         density(),
                         state.box().edges(),
                         averages_.averages(),
                         order_at_sampling_,
                         stages_,
                         {},
                         {},
                         simulation_.force_field.search_statistics(),
                         seconds};
        for (const auto& analysis : simulation_.analyses) {
            if (analysis->samples() > 0) {
                result.tables.push_back(analysis->result());
            }
        }
        result.warnings = doubts(result);
        for (const std::string& warning : result.warnings) {
            listener_.warning(warning);
        }
        files_.finish(state, result);
        return result;
    }

    /// What a reader of the results should know before trusting them.
    [[nodiscard]] std::vector<std::string> doubts(const RunResult& result) const {
        std::vector<std::string> doubts;
        if (deck_.total_steps() == 0) {
            return doubts;
        }
        if (result.averages.empty()) {
            doubts.emplace_back("no sample was taken: set sample = true in a stage longer than the thermo interval");
        }
        if (result.order_at_sampling && *result.order_at_sampling > crystal_left) {
            doubts.push_back(
                fmt::format("sampling began with {:.0f} % of the crystal left (translational order {:.3f}): "
                            "equilibrate longer, or melt above the target temperature first",
                            100.0 * *result.order_at_sampling, *result.order_at_sampling));
        }
        std::string unsure;
        bool all_unsure = true;
        for (const ObservableAverage& average : result.averages) {
            const bool known =
                average.estimate && average.estimate->converged &&
                (average.estimate->independent_samples >= few_samples || average.estimate->standard_error == 0.0);
            if (!is_in_table(average.name)) {
                continue;
            }
            if (average.estimate && !known) {
                unsure += (unsure.empty() ? "" : ", ") + average.name;
            }
            all_unsure = all_unsure && !known;
        }
        if (!unsure.empty()) {
            doubts.push_back(fmt::format("the run is too short for the error bars of {}: they are guesses",
                                         all_unsure ? "all observables" : unsure));
        }
        return doubts;
    }

    const Deck& deck_;
    Simulation& simulation_;
    RunListener& listener_;
    Every thermo_every_;
    RunDirectory files_;
    RunAverages averages_;
    Evaluation evaluation_;
    std::optional<double> order_at_sampling_;
    std::vector<StageResult> stages_;
    Index step_ = 0;     ///< that is being taken
    std::string stage_;  ///< that is running; empty before the first one
};

}  // namespace

RunResult run_deck(const Deck& deck, Simulation& simulation, RunListener& listener) {
    return Loop(deck, simulation, listener).run();
}

}  // namespace ljmd
