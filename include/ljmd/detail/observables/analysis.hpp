#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/ensemble.hpp"
#include "ljmd/detail/observables/statistics/known_quantity.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/detail/potentials/interaction.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

/// A result as a table of numbers, which becomes a file of its own.
struct DataTable {
    std::string name;                  ///< name of the file, without suffix
    std::vector<std::string> columns;  ///< header
    std::vector<std::vector<double>> rows;
};

/// Properties of the run that an analysis needs.
struct SampledRun {
    Index atoms;
    Box box;
    double time_step;  ///< time step of the sampled stages [tau]
    Index steps;       ///< steps of the longest sampled stage
    std::uint64_t seed;
    std::optional<double> held_temperature;  ///< held by the thermostat of the sampled stages; empty at constant energy

    std::optional<Interaction> interaction;    ///< empty while a deck is checked
    Ensemble ensemble = Ensemble::none;        ///< of the samples
    std::optional<double> held_pressure = {};  ///< held by the barostat of the sampled stages
    bool is_film = false;                      ///< liquid and vapour share the box, see is_film() of starts
};

/// A measurement on configurations during the sampled stages of a run. Sampling never changes the state.
class Analysis {
  public:
    virtual ~Analysis() = default;

    /// @return true if the configuration at this step of the run is to be sampled
    [[nodiscard]] virtual bool due(Index step) const = 0;

    /// @return true if the evaluation passed to sample() must contain energy and virial
    [[nodiscard]] virtual bool needs_energy() const { return false; }

    /// @param evaluation  at the positions of the state
    virtual void sample(const State& state, const Evaluation& evaluation) = 0;

    /// The next configuration does not continue the last one, because another stage begins.
    virtual void interrupt() {}

    /// Number of sampled configurations.
    [[nodiscard]] virtual Index samples() const = 0;

    /// Results so far; empty if too little has been sampled.
    [[nodiscard]] virtual std::vector<DataTable> tables() const = 0;

    /// Results that are single numbers, for results.json.
    [[nodiscard]] virtual std::vector<ObservableAverage> observables() const { return {}; }

    /// Everything that sampling has changed.
    virtual void archive(Archive& a) = 0;
};

/// Requirements of an analysis besides positions in a box, which a trajectory or a run of another kind may lack.
struct AnalysisNeeds {
    bool velocities = false;
    bool unwrapped_positions = false;
    bool interaction = false;           ///< SampledRun::interaction, and quantities computed from it
    bool fixed_box = true;              ///< uses SampledRun::box throughout; otherwise the box of each configuration
    bool continuous_potential = false;  ///< a step at the cutoff has impulses, which the forces lack
    bool constant_energy = false;       ///< sampled stages without thermostat
    bool homogeneous = false;           ///< its formula is for one phase that fills the box
};

/// Why options do not fit, as pairs of key and message.
using Misfits = std::vector<std::pair<std::string, std::string>>;

/// Approximate memory of an analysis in a run [bytes].
struct AnalysisSize {
    double kept;           ///< largest size of what is kept between samples, which checkpoints contain, too
    double fixed = 0.0;    ///< further memory from the first sample on
    double passing = 0.0;  ///< further memory during sampling
};

/// The options of an analysis, see Description. `every`, the steps between configurations, is among them.
class AnalysisOptions {
  public:
    virtual ~AnalysisOptions() = default;
    virtual void describe(Description& description) = 0;

    /// Why the options do not fit the run. Empty if they do.
    [[nodiscard]] virtual Misfits check(const SampledRun& /*run*/) const { return {}; }

    [[nodiscard]] virtual std::unique_ptr<Analysis> make(const SampledRun& run) const = 0;
    [[nodiscard]] virtual AnalysisSize size(const SampledRun& run) const = 0;

  protected:
    AnalysisOptions() = default;
    AnalysisOptions(const AnalysisOptions&) = default;
    AnalysisOptions& operator=(const AnalysisOptions&) = default;
};

/// How a table of an analysis is drawn.
struct AnalysisChart {
    const char* file;  ///< one of AnalysisMethod::files
    const char* x;     ///< its columns; errors are in y + "_standard_error"
    const char* y;
    const char* title;
    const char* caption = "";          ///< empty: says what the band of errors is
    bool lead = false;                 ///< it is shown first
    std::optional<double> level = {};  ///< to compare with
    const char* level_label = "";
    const char* expected = "";  ///< column of what y is expected to be, drawn as a line below dots; none
    const char* expected_label = "";
    bool logarithmic = false;       ///< the axis of y
    bool is_power_of_time = false;  ///< where times go on to long ones, the axis of y is logarithmic as theirs is
    bool as_dots = false;           ///< single values, which no line joins
    const char* group = "";         ///< column whose values each are a line of their own
};

/// An analysis, as [analysis] selects it. Each is one file in src/observables/analyses.
struct AnalysisMethod {
    std::string name;  ///< the key in [analysis]
    std::string meaning;
    std::vector<std::string> files;  ///< names of its tables
    bool follows_time = false;       ///< compares configurations at different times
    AnalysisNeeds needs = {};
    bool is_random = false;                      ///< it draws random numbers
    bool of_crystal = false;                     ///< a deck that has it wants a crystal
    std::vector<KnownQuantity> quantities = {};  ///< columns of its tables and results, but for the samples'
    std::vector<AnalysisChart> charts = {};
    std::function<std::unique_ptr<AnalysisOptions>()> options;  ///< at their defaults
};

using ChosenAnalysis = Chosen<AnalysisMethod, AnalysisOptions>;

/// All analyses, in alphabetical order.
[[nodiscard]] std::vector<AnalysisMethod> all_analyses();

/// @throws InputError for an unknown name
[[nodiscard]] AnalysisMethod find_analysis(const std::string& name);

/// The analysis of a choice with its options. @throws InputError see chosen()
[[nodiscard]] ChosenAnalysis chosen_analysis(const Choice& choice);

}  // namespace ljmd
