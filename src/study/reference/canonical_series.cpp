#include "study/reference/canonical_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/tables/data_table_csv.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/statistics/equilibration.hpp"
#include "run/recorded_results.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

Index first_sampled_step(const fs::path& results) {
    const std::vector<RecordedStage> stages = read_results(results).stages;
    const auto sampled = std::ranges::find_if(stages, &RecordedStage::sampled);
    if (sampled == stages.end()) {
        throw DataError(fmt::format("{} tells of no stage that was sampled", results.string()));
    }
    return sampled->first_step;
}

Estimate estimate_of(std::vector<double>::const_iterator begin, std::vector<double>::const_iterator end) {
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (auto value = begin; value != end; ++value) {
        blocks.add(Eigen::VectorXd::Constant(1, *value));
    }
    return blocks.estimate(0);
}

}  // namespace

CanonicalSeries canonical_series(const fs::path& run, double density, double temperature) {
    const Index first = first_sampled_step(run / "results.json");
    const fs::path path = run / "thermo.csv";
    const DataTable thermo = read_csv(path);
    const auto step = step_column(thermo, path);
    const auto kinetic = full_column(thermo, "temperature", path);
    const auto energy = full_column(thermo, "potential_energy", path);
    const auto pressure = full_column(thermo, "pressure", path);
    CanonicalSeries series;
    for (std::size_t k = 0; k < step.size(); ++k) {
        if (step[k] > first) {
            series.energy.push_back(energy[k]);
            series.pressure.push_back(pressure[k] + density * (temperature - kinetic[k]));
        }
    }
    if (series.energy.empty()) {
        throw DataError(fmt::format("{} has no row behind step {}, where sampling begins", path.string(), first));
    }
    return series;
}

FoundEquilibration found_equilibration(const std::vector<CanonicalSeries>& runs) {
    FoundEquilibration found{0, 1.0, std::numeric_limits<double>::infinity()};
    for (const CanonicalSeries& run : runs) {
        const auto rows = static_cast<Index>(run.energy.size());
        for (const Equilibration& one : detect_equilibration({{run.energy}, {run.pressure}})) {
            const Index start = one.start.value_or(rows / 2);
            const bool known = !one.changes && std::isfinite(one.inefficiency);
            found.rows = std::max(found.rows, start);
            found.inefficiency = std::max(found.inefficiency, one.inefficiency);
            found.independent =
                std::min(found.independent, known ? static_cast<double>(rows - start) / one.inefficiency : 0.0);
        }
    }
    return found;
}

double difference_of_halves(const std::vector<std::vector<double>>& runs) {
    double difference = 0.0;
    double variance = 0.0;
    for (const std::vector<double>& run : runs) {
        const auto middle = run.begin() + static_cast<std::ptrdiff_t>(run.size() / 2);
        const Estimate first = estimate_of(run.begin(), middle);
        const Estimate second = estimate_of(middle, run.end());
        difference += second.mean - first.mean;
        variance += first.standard_error * first.standard_error + second.standard_error * second.standard_error;
    }
    return variance > 0.0 ? difference / std::sqrt(variance) : 0.0;
}

}  // namespace ljmd
