#pragma once

#include "report/run_facts.hpp"

namespace ljmd {

/// The page of a run of a fluid.
[[nodiscard]] PageContent fluid_page(const RunFacts& facts);

}  // namespace ljmd
