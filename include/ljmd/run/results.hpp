#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ljmd/run/run.hpp"

namespace ljmd {

/// results.json: every observable with mean, standard error, number of independent samples and unit, reduced and, for a
/// substance, in SI; the stages with their energy drift; warnings. Undefined numbers are null.
[[nodiscard]] std::string results_json(const Deck& deck, const RunResult& result);

/// Whether the table that a run ends with has a line for an observable; components of the pressure tensor and the
/// virial are in results.json only.
[[nodiscard]] bool is_in_table(const std::string& observable);

/// The remark on a number whose error bar is a guess (Estimate::converged).
inline constexpr std::string_view guessed_error =
    "its error bar is a guess: the series is too short for its correlations";

/// What a reader has to know of an observable: its remark, and whether its error bar is a guess.
[[nodiscard]] std::string remark_of(const ObservableAverage& average);

/// Observables by name, each with mean, standard_error, independent_samples, samples, error_is_converged, unit, si for
/// a substance, and remark where there is one.
[[nodiscard]] nlohmann::ordered_json observables_json(const std::vector<ObservableAverage>& averages,
                                                      const std::optional<SubstanceUnits>& units);

/// A header, one line an observable, and below them the remarks that numbers are marked with.
[[nodiscard]] std::string observables_table(const std::vector<ObservableAverage>& averages,
                                            const std::optional<SubstanceUnits>& units);

/// The line below such a table that tells what its samples are.
[[nodiscard]] std::string samples_footnote();

/// The names of observables in the table whose error bars are guesses, "pressure, diffusion"; "all observables" where
/// no error bar can be relied upon.
[[nodiscard]] std::string unsure_of(const std::vector<ObservableAverage>& averages);

/// The table that a run ends with: one line an observable, reduced and, for a substance, in K, bar, kJ/mol, g/cm3.
[[nodiscard]] std::string results_table(const Deck& deck, const RunResult& result);

/// A table with SI columns behind the reduced ones: r_nm for r, time_ps for time, k_per_nm for k, msd_nm2 for msd.
[[nodiscard]] DataTable with_si_columns(DataTable table, const std::optional<SubstanceUnits>& units);

}  // namespace ljmd
