#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// An observable of a run: its mean over the sampled stages, with its error.
struct ObservableAverage {
    std::string name;                  ///< as in results.json
    std::string symbol;                ///< for tables
    std::string unit;                  ///< reduced, e.g. "epsilon/k_B"
    std::optional<Estimate> estimate;  ///< empty if the observable has no value (temperature of one atom)
    std::string remark = {};           ///< note for the reader: why there is no value, or why to doubt it
    bool own = false;                  ///< measured by an Observer of the program that made the run
};

/// Whether the table at the end of a run shows an observable; components of the pressure tensor and the virial are only
/// in results.json.
[[nodiscard]] bool is_in_table(const ObservableAverage& average);

/// The remark on a number whose error bar is a guess (Estimate::converged).
inline constexpr std::string_view guessed_error =
    "its error bar is a guess: the series is too short for its correlations";

/// Remarks on an observable: its own, and whether its error bar is a guess.
[[nodiscard]] std::string remark_of(const ObservableAverage& average);

/// Names of the observables in the table whose error bars are guesses, "pressure, diffusion"; "all observables" if no
/// error bar is reliable.
[[nodiscard]] std::string unsure_of(const std::vector<ObservableAverage>& averages);

}  // namespace ljmd
