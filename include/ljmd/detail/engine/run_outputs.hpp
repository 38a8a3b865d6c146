#pragma once

#include <functional>
#include <optional>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/few_body/few_body.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// A sample of the thermodynamics of a fluid.
struct ThermoRow {
    Index step;
    double time;  ///< [tau]
    Thermodynamics values;
    std::optional<double> conserved_energy;  ///< per atom [epsilon]; empty in a stage without one
    std::optional<double> order;             ///< translational order; empty unless the start is a lattice
};

/// A sample of a few-body system, in the units of its deck.
struct FewBodyRow {
    Index step;
    double time;
    FewBodyTotals values;
};

/// Where a run puts its samples, frames and checkpoints: files, memory, a screen. The default keeps nothing.
class RunOutputs {
  public:
    virtual ~RunOutputs() = default;

    virtual void stage_begins(const Stage& /*stage*/) {}

    /// A sample, of the start and then every so many steps. A run of a fluid gives rows of the first kind, one of few
    /// bodies rows of the second.
    virtual void row(const ThermoRow& /*row*/) {}
    virtual void row(const FewBodyRow& /*row*/) {}

    /// The present errors of a stage that is to reach some, every so many samples.
    virtual void errors(const std::vector<ErrorSoFar>& /*errors*/) {}

    /// Whether frame() is to be called with this state, the end of a step. It is called with the start always.
    [[nodiscard]] virtual bool frame_is_due(const State& /*state*/) const { return false; }
    /// @param angle  polar angle of a radial motion, for forces that have one
    virtual void frame(const State& /*state*/, const std::optional<double>& /*angle*/) {}

    virtual void step_done(Index /*step*/) {}

    /// See LoopControl::wants_checkpoint.
    [[nodiscard]] virtual bool checkpoint_is_due(Index /*step*/, bool /*last_of_stage*/) { return false; }

    /// The run can be resumed from here. @param archive  writes everything that the rest of the run depends on
    virtual void checkpoint(const State& /*state*/, const LoopPosition& /*position*/,
                            const std::function<void(Archive&)>& /*archive*/) {}

  protected:
    RunOutputs() = default;
    RunOutputs(const RunOutputs&) = default;
    RunOutputs& operator=(const RunOutputs&) = default;
};

}  // namespace ljmd
