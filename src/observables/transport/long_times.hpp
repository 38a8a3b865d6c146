#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Whether a time is later by more than rounding.
[[nodiscard]] inline bool is_later(double time, double than) {
    return time > than * (1.0 + 1e-9);
}

/// The key `long_time` of an analysis: times beyond the largest of its LagTimes, in bounded memory.
struct LongTimeOption {
    std::optional<double> long_time = {};  ///< [tau]

    void describe(Description& description);

    /// Add mistakes in the option: a time that is not beyond the others, or longer than the longest sampled stage.
    /// @param lags      times that are measured without it
    /// @param analysis  its name for messages
    void check(const LagTimes& lags, const SampledRun& run, const std::string& analysis, Misfits& misfits) const;

    /// `lags`, and for n = 1, 2, ... as many times 2^n as far apart, until the largest is beyond `long_time`; of the
    /// last those up to `long_time`.
    [[nodiscard]] std::vector<LagTimes> levels(const LagTimes& lags) const;
};

/// A time correlation function at long times: the same analysis once more with every second configuration, once more
/// with every fourth, and so on. What level n finds is at times whose spacing is 2^n h; configurations are taken as
/// they are, never averaged, so that no value has a bias. Memory and time to compute: at most those of the first level
/// for each level, and twice those of the first level.
///
/// Tables are those of the first level, and, where they have a column `time`, continue with times of the next levels
/// that are larger than those before, in each group of rows that have the same values left of `time`. Observables are
/// those of the first level.
/// Sources: Frenkel and Smit, Understanding Molecular Simulation, 2nd ed., section 4.4.2; Ramirez et al. (2010),
/// doi:10.1063/1.3491098
class LongTimes : public Analysis {
  public:
    /// @param levels  level n is to find what it finds at every 2^n-th configuration; at least 1
    /// @param last    largest time of the tables [tau]
    /// @throws ContractViolation without levels
    LongTimes(std::vector<std::unique_ptr<Analysis>> levels, double last);

    [[nodiscard]] bool due(Index step) const override { return levels_.front()->due(step); }
    [[nodiscard]] bool needs_energy() const override { return levels_.front()->needs_energy(); }
    void sample(const State& state, const Evaluation& evaluation) override;
    void interrupt() override;
    [[nodiscard]] Index samples() const override { return levels_.front()->samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override;
    [[nodiscard]] std::vector<ObservableAverage> observables() const override { return levels_.front()->observables(); }
    void archive(Archive& a) override;

  private:
    std::vector<std::unique_ptr<Analysis>> levels_;
    double last_;
    Index frames_ = 0;  ///< since the last interruption
};

/// The analysis that `make` makes for the times of a run, with those of the option.
/// @param make  make(lags) -> std::unique_ptr<Analysis>
template <class Make>
[[nodiscard]] std::unique_ptr<Analysis> with_long_times(const LongTimeOption& option, const LagTimes& lags,
                                                        const Make& make) {
    if (!option.long_time) {
        return make(lags);
    }
    std::vector<std::unique_ptr<Analysis>> levels;
    for (const LagTimes& level : option.levels(lags)) {
        levels.push_back(make(level));
    }
    return std::make_unique<LongTimes>(std::move(levels), *option.long_time);
}

/// Memory of such an analysis. @param size  size(lags) -> AnalysisSize of a level
template <class Size>
[[nodiscard]] AnalysisSize with_long_times_size(const LongTimeOption& option, const LagTimes& lags, const Size& size) {
    AnalysisSize sum{.kept = 0.0};
    for (const LagTimes& level : option.levels(lags)) {
        const AnalysisSize one = size(level);
        sum.kept += one.kept;
        sum.fixed += one.fixed;
        sum.passing = std::max(sum.passing, one.passing);
    }
    return sum;
}

}  // namespace ljmd
