#pragma once

#include <filesystem>

#include "deck/run_plan.hpp"

namespace ljmd {

/// The run of a specification, whose record holds it as a deck. Lennard-Jones stands in there, and in the plan, for a
/// formula of the program, and its external force is left out: the caller gives both (RunPlan::given).
/// @param precision, start, and errors as in deck_text(), but that what a program gives is accepted
[[nodiscard]] RunPlan plan_of(const FluidSpec& spec, const RunFiles& files, Precision precision,
                              const std::filesystem::path& start);

}  // namespace ljmd
