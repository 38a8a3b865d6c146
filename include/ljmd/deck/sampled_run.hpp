#pragma once

#include "ljmd/core/section.hpp"
#include "ljmd/deck/deck.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/statistics/run_averages.hpp"

namespace ljmd {

/// What a deck tells the analyses about its run: the time step of the first sampled stage and the length of the longest
/// one; of the last stage where none is sampled. The interaction is left out.
/// @pre root has [system] and at least one [[stage]]
[[nodiscard]] SampledRun sampled_run(const Section& root, Index atoms, const Box& box);

/// The ensemble that the samples of a run are from. Those of several stages do not fluctuate as those of one.
[[nodiscard]] Ensemble sampled_ensemble(const Deck& deck);

/// Whether the values in [analysis] fit the run, and whether sampled stages have one time step where that matters.
/// @pre as above, and root has [analysis]
void check_analysis(const Section& root, const SampledRun& run, Diagnostics& diagnostics);

}  // namespace ljmd
