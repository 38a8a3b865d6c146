#pragma once

#include "python/memory_run.hpp"

namespace ljmd::python {

/// See memory_run().
[[nodiscard]] std::unique_ptr<MemoryRun> few_body_run(const Deck& deck);

}  // namespace ljmd::python
