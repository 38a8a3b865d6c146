#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ljmd/analyze/frame_selection.hpp"
#include "ljmd/deck/deck.hpp"
#include "ljmd/observables/analysis.hpp"

namespace ljmd {

/// An analysis that is fed with the frames of a trajectory. Its schedule counts frames.
struct FrameAnalysis {
    AnalysisMethod method;
    std::unique_ptr<Analysis> analysis;
};

/// What a trajectory is analyzed for when nothing is asked for: rdf, structure_factor where the box stays the same, and
/// msd where frames are equally spaced and it is known whether positions are wrapped.
[[nodiscard]] std::vector<std::string> usual_analyses(const TrajectorySummary& trajectory,
                                                      const FrameSelection& selection);

/// Refuse names that are neither those of analyses nor "thermo". @throws InputError
void check_analysis_names(const std::vector<std::string>& names);

/// Refuse a trajectory whose energies and pressures cannot be had: without velocities, or without a deck for the
/// interaction. @throws InputError
void check_thermo(const Deck* deck, const TrajectorySummary& trajectory, const FrameSelection& selection);

/// Make analyses for a trajectory. Their settings are those of the deck's [analysis] where it has them, else defaults;
/// the deck's `every`, which counts steps, becomes as many frames, one at least; where the deck does not ask for an
/// analysis every frame counts. Then `settings`, "analysis.rdf.bins=100", apply; their `every` counts frames.
///
/// @param names     of analyses, each once
/// @param settings  of --set
/// @param deck      for the interaction, the seed and what thermostats hold; may be null
/// @throws InputError  a setting is wrong or does not fit the trajectory; the trajectory or the deck lacks what an
///                     analysis needs: velocities, equally spaced frames, a box that stays the same, an interaction, or
///                     what tells whether positions are wrapped
[[nodiscard]] std::vector<FrameAnalysis> make_frame_analyses(const std::vector<std::string>& names,
                                                             const std::vector<std::string>& settings, const Deck* deck,
                                                             const TrajectorySummary& trajectory,
                                                             const FrameSelection& selection);

}  // namespace ljmd
