#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/crosscheck.hpp"
#include "judge/answer.hpp"
#include "judge/engine_speed.hpp"
#include "judge/exchange.hpp"
#include "judge/run_judgement.hpp"
#include "ljmd/detail/run/interruption.hpp"

namespace ljmd {

/// How far an engine's trajectory is from ljmd's at a step.
struct StepApart {
    Index step;
    double distance;                           ///< largest of an atom [sigma]
    std::optional<double> allowed{};           ///< distance; none where two programs no longer stay together
    std::optional<double> force_difference{};  ///< largest of forces at its own positions, over their root mean square
};

/// What an engine's answer is worth.
struct Judgement {
    std::string engine;  ///< its name, if it tells it; else how it was called
    Index atoms;
    Index steps_before;
    std::string path;  ///< of ljmd: pair search, SIMD level, precision, threads
    std::vector<Check> checks;
    std::vector<ComparedMean> means;
    std::vector<StepApart> trajectory{};  ///< at each judged step
    double time_step = 0.0;               ///< of the trajectory [tau]
    std::vector<std::string> diagnoses;   ///< known mistakes that explain what disagrees
    std::vector<std::string> not_judged;  ///< parts that the answer lacks, or is too short for
    std::vector<std::string> warnings;    ///< remarks on the files
    std::optional<EngineSpeed> speed{};   ///< if it was asked for, and could be told
    std::string own_failure{};  ///< why ljmd's own run of the deck failed; without it there is no verdict on averages

    [[nodiscard]] bool passed() const { return failures() == 0; }
    [[nodiscard]] Index failures() const;
};

/// What ljmd computes with, to judge an answer.
struct OwnSide {
    FluidSpec spec;
    Execution execution;
    std::string search;  ///< its name
};

/// The problem of a deck: its moment before the first sampled stage (the last one, if none is), which is judged.
/// @param fluid    that moment
[[nodiscard]] Problem problem_of(const Deck& deck, Fluid fluid, const CrosscheckOptions& options);

/// Judge an answer: each part that it has; what it lacks is named.
/// @param say           receives a line before each slow operation
/// @param interruption  asked after every step of ljmd's own run
/// @throws Interrupted
[[nodiscard]] Judgement judge(const Problem& problem, const Answer& answer, const OwnSide& own,
                              const std::function<void(const std::string&)>& say,
                              const Interruption& interruption = Interruption());

/// The table and the verdict, and the same as JSON.
[[nodiscard]] std::string judgement_table(const Judgement& found, const Deck& deck);
[[nodiscard]] std::string judgement_json(const Judgement& found, const Deck& deck, const std::string& with);

}  // namespace ljmd
