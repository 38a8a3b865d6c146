#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/document.hpp"
#include "deck/deck_system.hpp"
#include "engine/few_body_measurement.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "ljmd/detail/run/run_listener.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/engine/run_result.hpp"
#include "run/continuation.hpp"

namespace ljmd {

/// Run options that are not in the deck.
struct RunControl {
    Interruption interruption{};                    ///< when to stop, with a checkpoint
    std::optional<Continuation> continuation = {};  ///< from where to resume

    /// Called after the first checkpoint: the run can now be resumed.
    std::function<void()> has_begun = {};

    std::vector<Observer*> observers = {};  ///< of a fluid; when it is resumed, those that it had before
};

/// Run all stages of a deck and write its output directory (see docs/files.md): run.json at the beginning and the end,
/// thermo.csv and the trajectory during the run, final.xyz, the tables of the analyses and results.json at the end.
///
/// @param fluid, system  what the deck makes, see make_fluid() and make_few_body_system(); an external force of the
/// fluid is noted in run.json, and a run that had one is resumed with it
/// @pre  the output directory exists and has no earlier outputs, or it is the resumed run's
/// @throws PhysicsError, FileError, CheckpointError, Interrupted; files written until then stay
RunResult run_plan(const RunPlan& plan, FluidSystem& fluid, RunListener& listener, const RunControl& control = {});
FewBodyResult run_plan(const RunPlan& plan, FewBodySystem& system, RunListener& listener,
                       const RunControl& control = {});

/// The same for a system of either kind. @return the report of its results
Document run_plan(const RunPlan& plan, AnySystem& system, RunListener& listener, const RunControl& control = {});

/// Lock the output directory of a deck, set an earlier run in it aside, and run the deck there. The earlier run is
/// removed when the new one can be resumed, and put back when it fails before that.
/// @param replace  accept an earlier run in the directory
/// @pre check_directory() has accepted it  @throws InUseError, and as run_plan()
Document run_in_locked_directory(RunPlan& plan, AnySystem& system, bool replace, RunListener& listener,
                                 RunControl control = {});

}  // namespace ljmd
