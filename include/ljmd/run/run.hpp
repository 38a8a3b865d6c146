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

/// How one stage went.
struct StageResult {
    std::string name;
    std::string integrator;
    Index first_step;  ///< step of the run before its first one
    Index last_step;
    double time_step;  ///< [tau]
    bool sampled;
    bool thermostatted;
    bool reversed;                       ///< the motion was turned round at its start
    std::optional<double> energy_drift;  ///< least-squares slope of the conserved energy per atom [epsilon/tau]
    std::string checksum_at_start;       ///< of the positions, see checksum()
    std::string checksum_at_end;
    std::optional<double> time_step_error = {};  ///< see TimeStepError; of sampled stages of a fluid
    std::string drift_remark = {};               ///< why the drift is too large; of a run that is done
    std::string time_step_remark = {};           ///< why the time step is too long; of a run that is done

    void archive(Archive& a) {
        a(name, integrator, first_step, last_step, time_step, sampled, thermostatted, reversed, energy_drift,
          checksum_at_start, checksum_at_end, time_step_error);
    }
};

/// @throws CheckpointError unless these are the results of the stages of the deck that have begun
void require_stages(const std::vector<StageResult>& results, const Deck& deck, const LoopPosition& position);

/// What a run found.
struct RunResult {
    Index atoms;
    double density;  ///< [sigma^-3]
    Vec3 edges;      ///< [sigma]
    std::vector<ObservableAverage> averages;
    std::optional<double> asked_temperature;     ///< see asked_temperature()
    std::optional<AtAskedTemperature> at_asked;  ///< where it was not found, but can be reckoned with
    std::optional<double> order_at_sampling;     ///< translational order when sampling began
    std::vector<StageResult> stages;
    std::vector<DataTable> tables;      ///< of the analyses
    std::vector<std::string> warnings;  ///< about the results
    SearchStatistics search;
    PhaseSeconds seconds;  ///< wall time of the time loop
    Thermodynamics first;  ///< of the start
    Thermodynamics last;   ///< of the last row of thermo.csv
};

/// Receives what happens during a run. The default ignores it all.
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

/// How a run is to go, beside what its deck says.
struct RunControl {
    Interruption interruption{};  ///< stop then, with a checkpoint

    /// Go on from a checkpoint.
    struct Resumed {
        ResumePoint point;
        EarlierParts earlier;
    };
    std::optional<Resumed> resumed = {};

    /// Called when a run has its first checkpoint, from which it can be gone on with.
    std::function<void()> has_begun = {};
};

/// Run all stages of a deck and write its output directory (see docs/files.md): run.json when the run begins and when
/// it ends, thermo.csv and the trajectory while it goes, final.xyz, the analyses' tables and results.json at the end.
///
/// @pre  the output directory exists and is empty of earlier outputs, or it is the one of the run that is gone on with
/// @throws PhysicsError, FileError, CheckpointError, Interrupted; what was written until then stays
RunResult run_deck(const Deck& deck, Simulation& simulation, RunListener& listener, const RunControl& control = {});

}  // namespace ljmd
