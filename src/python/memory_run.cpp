#include "memory_run.hpp"

#include "few_body_run.hpp"
#include "fluid_run.hpp"

namespace ljmd::python {

std::unique_ptr<MemoryRun> memory_run(const Deck& deck, CheckedRun checked,
                                      const std::function<void(const std::string&)>& warn) {
    if (checked.start) {
        return fluid_run(deck, std::move(*checked.start), checked.execution, warn);
    }
    return few_body_run(deck);
}

}  // namespace ljmd::python
