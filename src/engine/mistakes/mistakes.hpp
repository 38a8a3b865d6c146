#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

// Ranges of values, for decks and specifications alike.
inline constexpr Index max_cells = 1000;      ///< of a crystal, along an edge
inline constexpr Index max_layers = 100'000;  ///< of a crystal, along z
inline constexpr double min_density = 1e-12;  ///< one atom in a box of 10^4 sigma [sigma^-3]
inline constexpr double min_cutoff = 0.01;    ///< r^-12 there is 10^24 [sigma]

/// Values of a specification that break a rule. Tables and keys have the names that they have in a deck, which can thus
/// show the place.
struct Mistake {
    std::string table;    ///< "system", "potential", "neighbors", "performance", "stage", "body" or "analysis"
    std::string name;     ///< of the stage or the analysis
    std::size_t index;    ///< of the stage or the body
    std::string message;  ///< a sentence, or what follows the name of the first key: "is 3, not below the cutoff 2.5"
    bool follows_key;     ///< the message is the latter
    std::vector<std::string> keys;  ///< the value to change, then those that it does not go with; "thermostat.type" is
                                    ///< in a table of its own; none: the table as a whole
    std::string hint;               ///< what to do; may be empty
};

/// For users of the library: "stage 'production': a barostat needs a canonical thermostat beside it".
[[nodiscard]] std::string in_words(const Mistake& mistake);

// The rules. Each function knows one part of a run, so that a deck can be checked as far as its values are sound.

/// Names, time steps and numbers of steps: the rules for stages of all kinds of runs.
[[nodiscard]] std::vector<Mistake> stage_mistakes(const std::vector<Stage>& stages);

/// Integrators, thermostats and barostats of a fluid's stages, and samples on both sides of a reversal: the second ones
/// are not independent of the first, whether or not the motion finds its way back to the last bit.
/// @pre the stages are completed()
[[nodiscard]] std::vector<Mistake> fluid_stage_mistakes(const std::vector<Stage>& stages);

/// What an external force does not go with: a barostat that is not told its virial, and analyses of the pair forces
/// alone.
[[nodiscard]] std::vector<Mistake> external_force_mistakes(const FluidSpec& spec);

/// Analyses of few bodies follow the motion step by step: they would mistake a gap between the sampled stages for one
/// long step, and a reversal for motion. @pre there are analyses
[[nodiscard]] std::vector<Mistake> few_body_sampling_mistakes(const std::vector<Stage>& stages);

/// More atoms than can be indexed, or none.
[[nodiscard]] std::vector<Mistake> lattice_mistakes(const LatticeStart& lattice);

[[nodiscard]] std::vector<Mistake> potential_mistakes(const std::string& truncation, const Cutoff& cutoff, bool tail);

/// The pair search, and what only a Verlet list does.
[[nodiscard]] std::vector<Mistake> search_mistakes(const NeighborSpec& neighbors, Precision precision);

/// A cutoff that is longer than half the box.
[[nodiscard]] std::vector<Mistake> cutoff_mistakes(double cutoff, const Box& box);

/// Stages whose samples the analyses cannot use. @pre there is a stage
[[nodiscard]] std::vector<Mistake> sampling_mistakes(const std::vector<Choice>& analyses,
                                                     const std::vector<Stage>& stages);

/// What is wrong with a potential that has a step, for analyses that need a continuous one: "... has a step at ...".
[[nodiscard]] std::string step_in_words(const std::string& truncation);

/// Truncation and thermostats that analyses do not go with (AnalysisNeeds::continuous_potential and constant_energy).
[[nodiscard]] std::vector<Mistake> analysis_need_mistakes(const std::vector<Choice>& analyses,
                                                          const std::string& truncation,
                                                          const std::vector<Stage>& stages);

/// Options of analyses that do not fit the run and its box.
[[nodiscard]] std::vector<Mistake> analysis_mistakes(const std::vector<Choice>& analyses, const SampledRun& run);

/// The mistakes that depend on the box: cutoff and analyses that do not fit into it.
/// @pre mistakes() finds no others in the specification
[[nodiscard]] std::vector<Mistake> box_mistakes(const FluidSpec& spec, Index atoms, const Box& box);

}  // namespace ljmd
