#pragma once

#include <optional>
#include <string>

#include "ljmd/app/run.hpp"

namespace ljmd {

/// results.json: every observable with mean, standard error, number of independent samples and unit, reduced and, for a
/// substance, in SI; the stages with their energy drift; warnings. Undefined numbers are null.
[[nodiscard]] std::string results_json(const Deck& deck, const RunResult& result);

/// Whether the table that a run ends with has a line for an observable; components of the pressure tensor and the
/// virial are in results.json only.
[[nodiscard]] bool is_in_table(const std::string& observable);

/// The table that a run ends with: one line an observable, reduced and, for a substance, in K, bar, kJ/mol, g/cm3.
[[nodiscard]] std::string results_table(const Deck& deck, const RunResult& result);

/// A table with SI columns behind the reduced ones: r_nm for r, time_ps for time, k_per_nm for k, msd_nm2 for msd.
[[nodiscard]] DataTable with_si_columns(DataTable table, const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
