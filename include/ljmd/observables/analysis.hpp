#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/description.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/statistics/observable_average.hpp"
#include "ljmd/potentials/interaction.hpp"

namespace ljmd {

/// A result as columns of numbers, to be written as a file of its own.
struct DataTable {
    std::string name;                  ///< of the file, without suffix
    std::vector<std::string> columns;  ///< header
    std::vector<std::vector<double>> rows;
};

/// What an analysis has to know of the run that it is made for.
struct SampledRun {
    Index atoms;
    Box box;
    double time_step;  ///< of the sampled stages [tau]
    Index steps;       ///< of the longest one
    std::uint64_t seed;
    std::optional<double> held_temperature;  ///< by the thermostat of the sampled stages; none: constant energy

    std::optional<Interaction> interaction;  ///< not known while a deck is checked
};

/// Something measured on configurations during the sampled stages of a run. Sampling never changes the state.
class Analysis {
  public:
    virtual ~Analysis() = default;

    /// @return true when a configuration at this step of the run is wanted
    [[nodiscard]] virtual bool due(Index step) const = 0;

    /// @return true when the evaluation that sample() is given must hold energy and virial
    [[nodiscard]] virtual bool needs_energy() const { return false; }

    /// @param evaluation  of the forces at the state's positions
    virtual void sample(const State& state, const Evaluation& evaluation) = 0;

    /// What follows does not go on from the last configuration: another stage begins.
    virtual void interrupt() {}

    /// Configurations that were sampled.
    [[nodiscard]] virtual Index samples() const = 0;

    /// What has been found so far; nothing where too little has been sampled.
    [[nodiscard]] virtual std::vector<DataTable> tables() const = 0;

    /// Single numbers among it, for results.json.
    [[nodiscard]] virtual std::vector<ObservableAverage> observables() const { return {}; }

    /// All that sampling has changed.
    virtual void archive(Archive& a) = 0;
};

/// What an analysis cannot do without, beside positions in a box: what a trajectory or a run of another kind may lack.
struct AnalysisNeeds {
    bool velocities = false;
    bool unwrapped_positions = false;
    bool interaction = false;  ///< SampledRun::interaction, and what follows from it
    bool fixed_box = true;     ///< it is made for SampledRun::box; else that of each configuration counts
};

/// Reasons why options do not fit what they are for: (key, message).
using Misfits = std::vector<std::pair<std::string, std::string>>;

/// Bytes that an analysis takes in a run, about.
struct AnalysisSize {
    double kept;           ///< from one sample to the next, at most; a checkpoint holds them, too
    double fixed = 0.0;    ///< beside them, from its first sample on
    double passing = 0.0;  ///< beside these, while it samples
};

/// The options of an analysis, see Description. `every`, the steps between configurations, is among them.
class AnalysisOptions {
  public:
    virtual ~AnalysisOptions() = default;
    virtual void describe(Description& description) = 0;

    /// Why they do not fit the run; empty when all is well.
    [[nodiscard]] virtual Misfits check(const SampledRun& /*run*/) const { return {}; }

    [[nodiscard]] virtual std::unique_ptr<Analysis> make(const SampledRun& run) const = 0;
    [[nodiscard]] virtual AnalysisSize size(const SampledRun& run) const = 0;

  protected:
    AnalysisOptions() = default;
    AnalysisOptions(const AnalysisOptions&) = default;
    AnalysisOptions& operator=(const AnalysisOptions&) = default;
};

/// A kind of analysis that [analysis] can ask for. One file in src/observables/analyses each.
struct AnalysisMethod {
    std::string name;  ///< the key in [analysis]
    std::string meaning;
    std::vector<std::string> files;  ///< names of its tables
    bool follows_time = false;       ///< it compares configurations at different times
    AnalysisNeeds needs = {};
    bool is_random = false;                                     ///< it draws random numbers
    std::function<std::unique_ptr<AnalysisOptions>()> options;  ///< at their defaults
};

/// Every analysis there is, in alphabetical order.
[[nodiscard]] std::vector<AnalysisMethod> all_analyses();

}  // namespace ljmd
