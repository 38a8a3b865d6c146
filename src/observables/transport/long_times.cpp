#include "observables/transport/long_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"

namespace ljmd {

namespace {

using Rows = std::vector<std::vector<double>>;

/// Continue a table with the later times of another one that has the same columns.
void add_later(DataTable& table, const DataTable& coarser, double last) {
    const auto column = std::ranges::find(table.columns, "time") - table.columns.begin();
    if (column == std::ssize(table.columns)) {
        return;
    }
    const auto time = static_cast<std::size_t>(column);
    const auto is_same_group = [&](const std::vector<double>& a, const std::vector<double>& b) {
        return std::equal(a.begin(), a.begin() + column, b.begin());
    };
    Rows joined;
    joined.reserve(table.rows.size() + coarser.rows.size());
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        joined.push_back(table.rows[i]);
        if (i + 1 < table.rows.size() && is_same_group(table.rows[i], table.rows[i + 1])) {
            continue;
        }
        const std::vector<double>& end = table.rows[i];
        std::ranges::copy_if(coarser.rows, std::back_inserter(joined), [&](const std::vector<double>& row) {
            return is_same_group(row, end) && is_later(row[time], end[time]) && !is_later(row[time], last);
        });
    }
    table.rows = std::move(joined);
}

}  // namespace

void LongTimeOption::describe(Description& description) {
    description.number("long_time", long_time)
        .dimension(Dimension::time)
        .unit("tau")
        .above(0.0)
        .optional("nothing beyond `max_time`")
        .meaning("times beyond `max_time` up to this one, too, twice as far apart with each doubling");
}

void LongTimeOption::check(const LagTimes& lags, const SampledRun& run, const std::string& analysis,
                           Misfits& misfits) const {
    if (!long_time) {
        return;
    }
    const double known = lags.time(lags.count);
    if (!is_later(*long_time, known)) {
        misfits.emplace_back("long_time",
                             fmt::format("'long_time' in {} is {:.6g}, but times up to {:.6g} are measured without it "
                                         "(`max_time`)",
                                         analysis, *long_time, known));
        return;
    }
    const double sampled = static_cast<double>(run.steps) * run.time_step;
    if (run.steps > 0 && is_later(*long_time, sampled)) {
        misfits.emplace_back("long_time",
                             fmt::format("'long_time' in {} is {:.6g}, but no more than {:.6g} tau are sampled at a "
                                         "stretch",
                                         analysis, *long_time, sampled));
    }
}

std::vector<LagTimes> LongTimeOption::levels(const LagTimes& lags) const {
    std::vector<LagTimes> all{lags};
    if (!long_time) {
        return all;
    }
    // A level has a time beyond the one before if twice its spacing fits often enough.
    while (is_later(*long_time, all.back().time(all.back().count)) &&
           all.back().every <= std::numeric_limits<Index>::max() / 2) {
        LagTimes next = all.back();
        next.every *= 2;
        next.spacing *= 2.0;
        next.count = std::min(lags.count, static_cast<Index>(std::floor(*long_time / next.spacing * (1.0 + 1e-9))));
        if (next.count < 1 || next.time(next.count) <= all.back().time(all.back().count)) {
            break;
        }
        all.push_back(next);
    }
    return all;
}

LongTimes::LongTimes(std::vector<std::unique_ptr<Analysis>> levels, double last)
    : levels_(std::move(levels)), last_(last) {
    if (levels_.empty()) {
        throw ContractViolation("long times of no analysis");
    }
}

void LongTimes::sample(const State& state, const Evaluation& evaluation) {
    Index spacing = 1;
    for (const auto& level : levels_) {
        if (frames_ % spacing != 0) {
            break;  // nor will a coarser level take this configuration
        }
        level->sample(state, evaluation);
        spacing *= 2;
    }
    ++frames_;
}

void LongTimes::interrupt() {
    for (const auto& level : levels_) {
        level->interrupt();
    }
    frames_ = 0;
}

std::vector<DataTable> LongTimes::tables() const {
    std::vector<DataTable> all = levels_.front()->tables();
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        for (const DataTable& coarser : levels_[level]->tables()) {
            const auto table = std::ranges::find(all, coarser.name, &DataTable::name);
            if (table != all.end()) {
                add_later(*table, coarser, last_);
            }
        }
    }
    return all;
}

void LongTimes::archive(Archive& a) {
    a(frames_);
    require_count(frames_);
    for (const auto& level : levels_) {
        level->archive(a);
    }
}

}  // namespace ljmd
