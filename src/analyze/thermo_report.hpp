#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/statistics/equilibration.hpp"
#include "run/recorded_run.hpp"

namespace ljmd {

/// Equilibration of the rows of thermo.csv in the sampled stages of a run; in all stages if none is sampled.
struct ThermoReport {
    struct Column {
        ObservableAverage average;  ///< of the rows from the start on; of all where there is no start
        ObservableAverage of_all;   ///< of all rows, as in results.json
        Equilibration found;        ///< see detect_equilibration()
        bool conserved;             ///< the total energy at constant energy: it has no start
        double whole_inefficiency;  ///< statistical inefficiency of all rows
    };

    Index rows;
    Index first_step;
    Index last_step;
    double interval;  ///< between rows [tau]
    std::vector<Column> columns;
    /// From the fluctuations of all rows: c_v, see RunAverages, and what they determine of ResponseFunctions.
    std::vector<ObservableAverage> of_fluctuations = {};
};

/// @param run   of a fluid; may still be running
/// @param from  rows before this time [tau] are excluded
/// @throws InputError  it is a few-body run
/// @throws DataError   its thermo.csv cannot be used, or fewer than two rows are left
[[nodiscard]] ThermoReport thermo_report(const RecordedRun& run, std::optional<double> from = std::nullopt);

/// "found", "too short to tell", "still changing" or "conserved": whether the start of equilibrium is known.
[[nodiscard]] std::string state_of(const ThermoReport::Column& column);

/// (g - 1)/2 rows as a time [tau], with g = rows/independent rows. Empty for a conserved energy and where it is
/// unknown.
[[nodiscard]] std::optional<double> correlation_time(const ThermoReport& report, const ThermoReport::Column& column);

/// The step of the first row in equilibrium. Empty if there is no start.
[[nodiscard]] std::optional<Index> equilibrated_at_step(const ThermoReport& report, const ThermoReport::Column& column);

/// The report as a document. Text: one line per column, with the step from which it is in equilibrium; below it the
/// remarks. Data: rows, first_step, last_step, interval; observables, by name: equilibrium (state_of()),
/// equilibrated_at_row, equilibrated_at_step (null without a start), statistical_inefficiency, correlation_time,
/// independent_samples, mean, standard_error, error_is_converged, and for all rows statistical_inefficiency_of_all,
/// mean_of_all, blocking_standard_error_of_all. What fluctuations determine in the ensemble, by name
/// (heat_capacity_cv, isothermal_compressibility): mean, standard_error. Remarks, if there are any.
[[nodiscard]] Document thermo_document(const ThermoReport& report);

}  // namespace ljmd
