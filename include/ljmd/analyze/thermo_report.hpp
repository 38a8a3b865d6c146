#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/document.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/observables/statistics/equilibration.hpp"
#include "ljmd/observables/statistics/observable_average.hpp"
#include "ljmd/run/recorded_run.hpp"

namespace ljmd {

/// Equilibration of the rows of thermo.csv in the sampled stages of a run; in all stages if none is sampled.
struct ThermoReport {
    struct Column {
        std::string name;
        Equilibration found;
        double whole_inefficiency;  ///< statistical inefficiency of all rows
        Estimate by_blocking;       ///< of all rows, as in results.json
    };

    Index rows;
    Index first_step;
    Index last_step;
    double interval;  ///< between rows [tau]
    Index stride;     ///< rows between candidate start rows
    std::vector<Column> columns;
    /// From the fluctuations of all rows: c_v, see RunAverages, and what they determine of ResponseFunctions.
    std::vector<ObservableAverage> of_fluctuations = {};
};

/// @param run   of a fluid; may still be running
/// @param from  rows before this time [tau] are excluded
/// @throws InputError  it is a few-body run
/// @throws DataError   its thermo.csv cannot be used, or fewer than two rows are left
[[nodiscard]] ThermoReport thermo_report(const RecordedRun& run, std::optional<double> from = std::nullopt);

/// The report as a document. Text: one line per column, with the step from which it is in equilibrium; below it the
/// remarks. Data: rows, first_step, last_step, interval, stride; observables, by name: equilibrated_at_row,
/// equilibrated_at_step, statistical_inefficiency, correlation_time, independent_samples, mean, standard_error, and for
/// all rows statistical_inefficiency_of_all, mean_of_all, blocking_standard_error_of_all. What
/// fluctuations determine in the ensemble, by name (heat_capacity_cv, isothermal_compressibility): mean,
/// standard_error. Remarks, if there are any.
[[nodiscard]] Document thermo_document(const ThermoReport& report);

}  // namespace ljmd
