#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/observables/statistics/equilibration.hpp"
#include "ljmd/observables/statistics/observable_average.hpp"
#include "ljmd/run/recorded_run.hpp"

namespace ljmd {

/// Where the rows of thermo.csv in the sampled stages of a run have come to equilibrium; of all stages where none is
/// sampled.
struct ThermoReport {
    struct Column {
        std::string name;
        Equilibration found;
        double whole_inefficiency;  ///< statistical inefficiency of all rows
        Estimate by_blocking;       ///< of all rows, as results.json has it
    };

    Index rows;
    Index first_step;
    Index last_step;
    double interval;  ///< between rows [tau]
    Index stride;     ///< rows between the starts that were tried
    std::vector<Column> columns;
    std::optional<ObservableAverage> heat_capacity = {};  ///< c_v from the fluctuations of all rows, see RunAverages
};

/// @param run   of a fluid; may still be going on
/// @param from  rows before this time [tau] are left out
/// @throws InputError  it is one of few bodies
/// @throws DataError   its thermo.csv cannot be used, or has fewer than two rows to look at
[[nodiscard]] ThermoReport thermo_report(const RecordedRun& run, std::optional<double> from = std::nullopt);

/// For people: one line a column, steps and times since the first row; below them the remarks that numbers are marked
/// with.
[[nodiscard]] std::string thermo_table(const ThermoReport& report);

/// rows, first_step, last_step, interval, stride; observables, by name: equilibrated_at_row, equilibrated_at_step,
/// statistical_inefficiency, correlation_time, independent_samples, mean, standard_error; of all rows:
/// statistical_inefficiency_of_all, mean_of_all, blocking_standard_error_of_all. Where the
/// ensemble has one, heat_capacity_cv: mean, standard_error. Remarks, where there are any.
[[nodiscard]] std::string thermo_json(const ThermoReport& report);

}  // namespace ljmd
