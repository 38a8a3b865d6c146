#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/analyze/thermo_report.hpp"
#include "ljmd/report/run_facts.hpp"

namespace ljmd {

/// Whether the sampled rows are in equilibrium. They are if leaving out what detect_equilibration() leaves out changes
/// no mean of temperature, potential energy or pressure by more than two of its errors, and if there are at least 16
/// independent rows; and if the crystal of the start was gone when sampling began.
/// @param order  translational order when sampling began, if the run started from a lattice
[[nodiscard]] Verdict equilibrium_verdict(const ThermoReport& report, const std::optional<double>& order = {});

/// Statements about a fluid's results: conservation of energy, error bars, temperature, time step.
[[nodiscard]] std::vector<Verdict> result_verdicts(const RunFacts& facts);

/// Whether energy and pressure agree with an equation of state, within three errors.
/// @param equation  its name, or why there is none
[[nodiscard]] Verdict reference_verdict(const std::vector<Quantity>& quantities, const std::string& equation);

}  // namespace ljmd
