#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/deck/asked_temperature.hpp"
#include "ljmd/deck/simulation.hpp"
#include "ljmd/engine/phase_seconds.hpp"
#include "ljmd/observables/statistics/run_averages.hpp"
#include "ljmd/run/interruption.hpp"
#include "ljmd/run/run_checkpoints.hpp"
#include "ljmd/run/run_record.hpp"

namespace ljmd {

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
    std::optional<double> time_step_error = {};  ///< see TimeStepError; for sampled stages of a fluid
    std::string drift_remark = {};               ///< why the drift is too large; set at the end of the run
    std::string time_step_remark = {};           ///< why the time step is too long; set at the end of the run

    void archive(Archive& a) {
        a(name, integrator, first_step, last_step, time_step, sampled, thermostatted, reversed, energy_drift,
          checksum_at_start, checksum_at_end, time_step_error);
    }
};

/// @throws CheckpointError unless these are the results of exactly those stages of the deck that have begun
void require_stages(const std::vector<StageResult>& results, const Deck& deck, const LoopPosition& position);

/// Results of a run.
struct RunResult {
    Index atoms;
    double density;  ///< [sigma^-3]
    Vec3 edges;      ///< [sigma]
    std::vector<ObservableAverage> averages;
    std::optional<double> asked_temperature;     ///< see asked_temperature()
    std::optional<AtAskedTemperature> at_asked;  ///< converted, if the run missed that temperature
    std::optional<double> order_at_sampling;     ///< translational order when sampling began
    std::vector<StageResult> stages;
    std::vector<DataTable> tables;      ///< of the analyses
    std::vector<std::string> warnings;  ///< about the results
    SearchStatistics search;
    PhaseSeconds seconds;  ///< wall time of the time loop
    Thermodynamics first;  ///< of the start
    Thermodynamics last;   ///< of the last row of thermo.csv
};

/// Receives the events of a run. The default ignores them.
class RunListener {
  public:
    virtual ~RunListener() = default;
    virtual void stage_begins(const Stage&) {}
    virtual void step_done(Index /*step*/) {}
    virtual void warning(const std::string& /*text*/) {}

  protected:
    RunListener() = default;
    RunListener(const RunListener&) = default;
    RunListener& operator=(const RunListener&) = default;
};

/// Run options that are not in the deck.
struct RunControl {
    Interruption interruption{};  ///< when to stop, with a checkpoint

    /// Resume from a checkpoint.
    struct Resumed {
        ResumePoint point;
        EarlierParts earlier;
    };
    std::optional<Resumed> resumed = {};

    /// Called after the first checkpoint: the run can now be resumed.
    std::function<void()> has_begun = {};
};

/// Run all stages of a deck and write its output directory (see docs/files.md): run.json at the beginning and the end,
/// thermo.csv and the trajectory during the run, final.xyz, the tables of the analyses and results.json at the end.
///
/// @pre  the output directory exists and has no earlier outputs, or it is that of the resumed run
/// @throws PhysicsError, FileError, CheckpointError, Interrupted; files written until then stay
RunResult run_deck(const Deck& deck, Simulation& simulation, RunListener& listener, const RunControl& control = {});

}  // namespace ljmd
