#pragma once

#include "report/run_facts.hpp"

namespace ljmd {

/// The page of a few-body run: playback of the tracks, error of the energy, orbits, what the analyses found.
[[nodiscard]] PageContent few_body_page(const RunFacts& facts);

}  // namespace ljmd
