#pragma once

#include "ljmd/core/section.hpp"
#include "ljmd/deck/deck.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/statistics/run_averages.hpp"

namespace ljmd {

/// Description of the run for the analyses: the time step of the first sampled stage and the length of the longest one;
/// of the last stage if none is sampled. The interaction is not set.
/// @pre root has [system] and at least one [[stage]]
[[nodiscard]] SampledRun sampled_run(const Section& root, Index atoms, const Box& box);

/// The ensemble of the samples of a run. Without a barostat, several sampled stages have none: their samples do not
/// fluctuate like those of one.
[[nodiscard]] Ensemble sampled_ensemble(const Deck& deck);

/// Check that the values in [analysis] fit the run, that the box stays constant, and that sampled stages have one time
/// step where analyses need that.
/// @pre as for sampled_run(), and root has [analysis]
void check_analysis(const Section& root, const SampledRun& run, Diagnostics& diagnostics);

}  // namespace ljmd
