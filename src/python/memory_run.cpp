#include "python/memory_run.hpp"

#include <utility>

#include "ljmd/core/errors.hpp"
#include "python/few_body_run.hpp"
#include "python/fluid_run.hpp"

namespace ljmd::python {

std::unique_ptr<MemoryRun> memory_run(const Deck& deck, CheckedRun checked,
                                      const std::shared_ptr<ExternalForce>& external,
                                      const std::function<void(const std::string&)>& warn) {
    if (checked.start) {
        return fluid_run(deck, std::move(*checked.start), checked.execution, external, warn);
    }
    if (external) {
        throw InputError("external forces are for fluids: this deck has few bodies");
    }
    return few_body_run(deck);
}

}  // namespace ljmd::python
