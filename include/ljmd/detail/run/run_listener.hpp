#pragma once

#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// Receives the events of a run. The default ignores them.
class RunListener {
  public:
    RunListener() = default;
    virtual ~RunListener() = default;
    virtual void stage_begins(const Stage&) {}
    virtual void step_done(Index /*step*/) {}

    /// A sample was taken, of a fluid or of few bodies; step_done() for its step comes later.
    virtual void sampled(const ThermoRow& /*row*/) {}
    virtual void sampled(const FewBodyRow& /*row*/) {}
    /// The present errors of a stage that is to reach some, every so many samples.
    virtual void errors(const std::vector<ErrorSoFar>& /*errors*/) {}
    virtual void warning(const std::string& /*text*/) {}

    /// A warning about the results, which the report of the run says, too.
    virtual void doubted(const std::string& text) { warning(text); }

  protected:
    RunListener(const RunListener&) = default;
    RunListener& operator=(const RunListener&) = default;
};

}  // namespace ljmd
