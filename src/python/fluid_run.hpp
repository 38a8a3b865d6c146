#pragma once

#include "deck/fluid.hpp"
#include "ljmd/forces/external_force.hpp"
#include "python/memory_run.hpp"

namespace ljmd::python {

/// See memory_run().
[[nodiscard]] std::unique_ptr<MemoryRun> fluid_run(const Deck& deck, Start start, const Execution& execution,
                                                   const std::shared_ptr<ExternalForce>& external,
                                                   const std::function<void(const std::string&)>& warn);

}  // namespace ljmd::python
