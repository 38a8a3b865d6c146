#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyze/thermo_report.hpp"
#include "report/run_facts.hpp"

namespace ljmd {

/// Whether the sampled rows are in equilibrium, by detect_equilibration(): no column changes, and there are enough
/// independent rows to tell; and the crystal of the start was gone when sampling began.
/// @param crystal  translational order of the crystal that was left when sampling began, if one was
[[nodiscard]] Verdict equilibrium_verdict(const ThermoReport& report, const std::optional<double>& crystal = {});

/// Statements about a fluid's results: conservation of energy, error bars, temperature, time step.
[[nodiscard]] std::vector<Verdict> result_verdicts(const RunFacts& facts);

/// Whether energy and pressure agree with an equation of state, within three errors.
/// @param equation  its name, or why there is none
[[nodiscard]] Verdict reference_verdict(const std::vector<Quantity>& quantities, const std::string& equation);

}  // namespace ljmd
