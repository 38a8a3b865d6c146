#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ljmd/core/data.hpp"
#include "ljmd/run/run.hpp"

namespace ljmd {

/// results.json: every observable with mean, standard error, number of independent samples and unit, in reduced units
/// and, for a substance, in SI; the stages with their energy drift; warnings. Undefined numbers are null.
[[nodiscard]] std::string results_json(const Deck& deck, const RunResult& result);

/// Whether the table at the end of a run shows an observable; components of the pressure tensor and the virial are only
/// in results.json.
[[nodiscard]] bool is_in_table(const std::string& observable);

/// The remark on a number whose error bar is a guess (Estimate::converged).
inline constexpr std::string_view guessed_error =
    "its error bar is a guess: the series is too short for its correlations";

/// Remarks on an observable: its own, and whether its error bar is a guess.
[[nodiscard]] std::string remark_of(const ObservableAverage& average);

/// Observables by name, each with mean, standard_error, independent_samples, samples, error_is_converged, unit, si for
/// a substance, and remark if there is one.
[[nodiscard]] Data observables_data(const std::vector<ObservableAverage>& averages,
                                    const std::optional<SubstanceUnits>& units);

/// A header, one line per observable, and below them the remarks.
[[nodiscard]] std::string observables_table(const std::vector<ObservableAverage>& averages,
                                            const std::optional<SubstanceUnits>& units);

/// The line below such a table that explains its samples.
[[nodiscard]] std::string samples_footnote();

/// Names of the observables in the table whose error bars are guesses, "pressure, diffusion"; "all observables" if no
/// error bar is reliable.
[[nodiscard]] std::string unsure_of(const std::vector<ObservableAverage>& averages);

/// The table at the end of a run: one line per observable, in reduced units and, for a substance, in SI units.
[[nodiscard]] std::string results_table(const Deck& deck, const RunResult& result);

/// Add SI columns after the reduced ones: r_nm for r, time_ps for time, k_per_nm for k, msd_nm2 for msd.
[[nodiscard]] DataTable with_si_columns(DataTable table, const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
