#include "ljmd/detail/observables/statistics/observable_average.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ljmd {

bool is_in_table(const ObservableAverage& average) {
    return average.own || (!average.name.starts_with("pressure_") && average.name != "virial");
}

std::string remark_of(const ObservableAverage& average) {
    const bool guessed =
        average.estimate && !average.estimate->converged && !std::isnan(average.estimate->standard_error);
    if (!guessed) {
        return average.remark;
    }
    return average.remark.empty() ? std::string(guessed_error) : fmt::format("{}; {}", average.remark, guessed_error);
}

std::string unsure_of(const std::vector<ObservableAverage>& averages) {
    std::string unsure;
    bool all_unsure = true;
    for (const ObservableAverage& average : averages) {
        if (!is_in_table(average)) {
            continue;
        }
        const bool known = average.estimate && average.estimate->converged;
        if (known && std::isnan(average.estimate->independent_samples)) {
            continue;  // a conserved energy is not sampled
        }
        if (average.estimate && !known) {
            unsure += (unsure.empty() ? "" : ", ") + average.name;
        }
        all_unsure = all_unsure && !known;
    }
    return all_unsure && !unsure.empty() ? "all observables" : unsure;
}

}  // namespace ljmd
