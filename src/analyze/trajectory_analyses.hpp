#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analyze/frame_selection.hpp"
#include "deck/deck.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

/// An analysis of the frames of a trajectory. Its schedule counts frames.
struct FrameAnalysis {
    AnalysisMethod method;
    std::unique_ptr<Analysis> analysis;
};

/// Why frames that hold part of the atoms (TrajectorySummary::is_part) have no analysis that follows the motion.
inline constexpr const char* part_of_the_atoms =
    "motion is measured about the centre of mass of all of them, and the ids of the frames have gaps, or do not begin "
    "at "
    "0 or 1, as where a file holds part of the atoms";

/// The default analyses of a trajectory: rdf; structure_factor if the box is constant; msd if also the frames are
/// equally spaced and hold all atoms, and it is known whether positions are wrapped.
[[nodiscard]] std::vector<std::string> default_analyses(const TrajectorySummary& trajectory,
                                                        const FrameSelection& selection);

/// Refuse names that are neither analyses nor "thermo". @throws InputError
void check_analysis_names(const std::vector<std::string>& names);

/// Refuse a trajectory whose energies and pressures cannot be computed: it has no velocities, there is no deck for the
/// interaction, or the cutoff is more than half the box. @throws InputError
void check_thermo(const Deck* deck, const TrajectorySummary& trajectory, const FrameSelection& selection);

/// Create analyses for a trajectory. Their settings are from the deck's [analysis], else defaults. The deck's
/// `every`, which counts steps, is converted to frames, at least one; analyses that the deck does not ask for use every
/// frame. Then `settings`, "analysis.rdf.bins=100", are applied; their `every` counts frames.
///
/// @param names     of analyses, without repetition
/// @param settings  arguments of --set
/// @param deck      for the interaction, the seed and the temperature of thermostats; may be null
/// @throws InputError  a setting is wrong or does not fit the trajectory; or the trajectory or the deck lacks something
/// that an analysis needs: velocities, equally spaced frames, all atoms, a constant box, an interaction, or whether
/// positions are wrapped
[[nodiscard]] std::vector<FrameAnalysis> make_frame_analyses(const std::vector<std::string>& names,
                                                             const std::vector<std::string>& settings, const Deck* deck,
                                                             const TrajectorySummary& trajectory,
                                                             const FrameSelection& selection);

}  // namespace ljmd
