#pragma once

#include <optional>
#include <string>

#include "core/document.hpp"
#include "deck/deck.hpp"
#include "engine/few_body_measurement.hpp"
#include "ljmd/detail/core/data.hpp"
#include "ljmd/engine/run_result.hpp"

namespace ljmd {

/// The report at the end of a run. Data, in results.json: every observable with mean, standard error, number of
/// independent samples and unit, in reduced units and, for a substance, in SI; the stages with their energy drift;
/// warnings. Undefined numbers are null. Text, on the screen and in results.txt: a table with one line per observable,
/// in reduced units and, for a substance, in SI units; the stages.
[[nodiscard]] Document results_report(const RunPlan& plan, const RunResult& result);

/// The same for few bodies: every total with its history, what the analyses found, the stages.
[[nodiscard]] Document results_report(const RunPlan& plan, const FewBodyResult& result);

/// Observables by name, each with mean, standard_error, independent_samples, samples, error_is_converged, unit, si for
/// a substance, and remark if there is one.
[[nodiscard]] Data observables_data(const std::vector<ObservableAverage>& averages,
                                    const std::optional<SubstanceUnits>& units);

/// A header, one line per observable, and below them the remarks.
[[nodiscard]] std::string observables_table(const std::vector<ObservableAverage>& averages,
                                            const std::optional<SubstanceUnits>& units);

/// The line below such a table that explains its samples.
[[nodiscard]] std::string samples_footnote();

/// Add SI columns after the reduced ones: r_nm for r, time_ps for time, k_per_nm for k, msd_nm2 for msd.
[[nodiscard]] DataTable with_si_columns(DataTable table, const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
