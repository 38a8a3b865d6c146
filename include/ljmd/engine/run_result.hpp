#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/phase_seconds.hpp"
#include "ljmd/detail/engine/requested_temperature.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "ljmd/detail/neighbors/search_statistics.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"

namespace ljmd {

/// How a stage with `until` ended, or stands.
struct UntilResult {
    std::vector<ErrorSoFar> errors;
    Index max_steps;
    bool reached;  ///< all errors are, when the stage ended or steps were added to it
};

/// Results of one stage.
struct StageResult {
    std::string name;
    std::string integrator;
    Index first_step;  ///< the step before its first one, counted from the start of the run
    Index last_step;
    double time_step;  ///< [tau]
    bool sampled;
    bool thermostatted;
    bool reversed;                       ///< the velocities were reversed at its start
    std::optional<double> energy_drift;  ///< least-squares slope of the conserved energy per atom [epsilon/tau]
    std::string checksum_at_start;       ///< of the positions, see checksum()
    std::string checksum_at_end;
    std::optional<double> time_step_error = {};    ///< see TimeStepError; for sampled stages of a fluid
    std::optional<EnergyStart> energy_start = {};  ///< if the stage began at a given total energy
    std::string drift_remark = {};                 ///< why the drift is too large; set at the end of the run
    std::string time_step_remark = {};             ///< why the time step is too long; set at the end of the run
    std::optional<UntilResult> until = {};         ///< of a stage with `until`; set by result()

    void archive(Archive& a) {
        a(name, integrator, first_step, last_step, time_step, sampled, thermostatted, reversed, energy_drift,
          checksum_at_start, checksum_at_end, time_step_error, energy_start);
    }
};

/// The result of a stage that begins now. @param thermostatted  whether its energy flows from and to a thermostat
[[nodiscard]] StageResult begun_stage(const Stage& stage, const State& state, bool thermostatted);

/// @throws CheckpointError unless these are the results of exactly those stages that have begun
void require_stages(const std::vector<StageResult>& results, const std::vector<Stage>& stages,
                    const LoopPosition& position);

/// Results of a run of a fluid.
struct RunResult {
    Index atoms;
    double density;  ///< [sigma^-3]
    Vec3 edges;      ///< [sigma]
    std::vector<ObservableAverage> averages;
    std::optional<double> requested_temperature;         ///< see requested_temperature()
    std::optional<AtRequestedTemperature> at_requested;  ///< converted, if the run missed that temperature
    std::optional<std::string> equation_of_state;        ///< name of this fluid's, see equation_of_fluid()
    std::optional<double> order_at_sampling;             ///< translational order when sampling began
    std::vector<StageResult> stages;
    std::vector<DataTable> tables;      ///< of the analyses
    std::vector<std::string> warnings;  ///< about the results
    SearchStatistics search;
    PhaseSeconds seconds;  ///< wall time of the time loop
    Thermodynamics first;  ///< of the start
    Thermodynamics last;   ///< of the last sample

    std::string too_near = {};  ///< of pairs nearer than the potential's table, see PairsTooNear; empty: none were

    std::vector<std::string> doubts = {};  ///< the warnings that no remark on an observable repeats

    /// The observable of this name. @throws InputError naming all, if there is none
    [[nodiscard]] const ObservableAverage& observable(const std::string& name) const;

    /// The table of this name. @throws InputError naming all, if there is none
    [[nodiscard]] const DataTable& table(const std::string& name) const;
};

}  // namespace ljmd
