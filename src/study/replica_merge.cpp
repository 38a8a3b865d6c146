#include "study/replica_merge.hpp"
#include "core/gsl_errors.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace ljmd {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double freedom_of_run = 15.0;  // of its standard error, at least
constexpr double sure = 0.99;
constexpr double one_sigma = 0.682689492137086;  // probability of mean +- one standard deviation of a normal number
constexpr const char* error_suffix = "_standard_error";

/// The factor for an error with so many degrees of freedom.
double student_factor(double freedom) {
    const GslErrorCodes codes;
    return gsl_cdf_tdist_Pinv(0.5 * (1.0 + one_sigma), freedom);
}

bool same_rows(const DataTable& a, const DataTable& b) {
    return a.columns == b.columns && a.rows.size() == b.rows.size() &&
           std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(),
                      [](const auto& row, const auto& other) { return row.front() == other.front(); });
}

}  // namespace

MergedMean merged_mean(const std::vector<ReplicaMean>& runs) {
    double samples = 0.0;
    for (const ReplicaMean& run : runs) {
        samples += run.samples;
    }
    MergedMean merged{0.0, nan, 0.0, nan, true};
    for (const ReplicaMean& run : runs) {
        const double weight = run.samples / samples;
        merged.mean += weight * run.mean;
        merged.within += run.converged ? std::pow(weight * run.standard_error, 2) : nan;
    }
    merged.within = std::sqrt(merged.within);
    if (runs.size() == 1) {
        merged.standard_error = runs.front().standard_error;
        return merged;
    }
    const double freedom = static_cast<double>(runs.size()) - 1.0;
    double between = 0.0;
    for (const ReplicaMean& run : runs) {
        between += run.samples / samples * std::pow(run.mean - merged.mean, 2) / freedom;
    }
    merged.between = std::sqrt(between);
    const double within = merged.within * merged.within;
    const double freedom_within = freedom_of_run * static_cast<double>(runs.size());
    const bool known = std::isfinite(within);
    const GslErrorCodes codes;
    merged.agree = !known || between <= within * gsl_cdf_fdist_Pinv(sure, freedom, freedom_within);
    merged.standard_error = known && merged.agree
                                ? std::sqrt((freedom_within * within + freedom * between) / (freedom_within + freedom))
                                : student_factor(freedom) * merged.between;
    return merged;
}

DataTable merged_table(const std::vector<DataTable>& tables, const std::vector<double>& samples) {
    const DataTable& first = tables.front();
    DataTable merged{first.name, first.columns, {}};
    if (!std::ranges::all_of(tables, [&](const DataTable& table) { return same_rows(first, table); })) {
        return merged;
    }
    const auto column_of = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(first.columns, name) - first.columns.begin());
    };
    merged.rows = first.rows;
    for (std::size_t row = 0; row < first.rows.size(); ++row) {
        for (std::size_t column = 1; column < first.columns.size(); ++column) {
            if (first.columns[column].ends_with(error_suffix)) {
                continue;  // with its value
            }
            const std::size_t error = column_of(first.columns[column] + error_suffix);
            const bool has_error = error < first.columns.size();
            std::vector<ReplicaMean> runs;
            runs.reserve(tables.size());
            for (std::size_t k = 0; k < tables.size(); ++k) {
                const std::vector<double>& values = tables[k].rows[row];
                runs.push_back({values[column], has_error ? values[error] : nan, samples[k], true});
            }
            const MergedMean mean = merged_mean(runs);
            merged.rows[row][column] = mean.mean;
            if (has_error) {
                merged.rows[row][error] = mean.standard_error;
            }
        }
    }
    return merged;
}

}  // namespace ljmd
