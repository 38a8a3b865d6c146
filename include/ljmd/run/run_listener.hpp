#pragma once

#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

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

}  // namespace ljmd
