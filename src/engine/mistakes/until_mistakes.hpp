#pragma once

#include <string>
#include <vector>

#include "engine/mistakes/mistakes.hpp"
#include "ljmd/detail/options/units.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// An observable whose error a stage can be told to reach.
struct UntilObservable {
    std::string name;
    Dimension dimension;
    std::string unit;  ///< reduced
};

/// The observables that `until` in a stage knows: the ones in thermo.csv that RunAverages gives an error for.
[[nodiscard]] const std::vector<UntilObservable>& until_observables();

/// The rules for stages that end when errors are reached: only the last stage, sampled, with errors above 0 of
/// observables that have one.
[[nodiscard]] std::vector<Mistake> until_mistakes(const std::vector<Stage>& stages);

}  // namespace ljmd
