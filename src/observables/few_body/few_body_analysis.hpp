#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "forces/few_body_force.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/observables/few_body/finding.hpp"
#include "ljmd/options/choice.hpp"
#include "observables/few_body/polar_angle.hpp"

namespace ljmd {

/// Sample for an analysis at the end of a step, of the deck or of an adaptive integrator within it. Its time is
/// state.time.
struct FewBodySample {
    const State& state;
    std::optional<PolarAngle> angle;  ///< for forces with a polar angle besides the coordinate (radial-kepler)
};

/// A measurement on a few bodies, at every step of the sampled stages and at those that an adaptive integrator takes
/// within them. Sampling never changes the state.
class FewBodyAnalysis {
  public:
    virtual ~FewBodyAnalysis() = default;

    virtual void sample(const FewBodySample& now) = 0;

    /// Results so far; those that cannot be known yet are left out.
    [[nodiscard]] virtual std::vector<Finding> findings() const = 0;

    /// Single events, which become a file of their own.
    [[nodiscard]] virtual std::optional<DataTable> table() const = 0;

    /// Everything that sampling has changed.
    /// @param now  state from which sampling continues  @throws CheckpointError if it cannot continue from there
    virtual void archive(Archive& a, const State& now) = 0;

  protected:
    FewBodyAnalysis() = default;
    FewBodyAnalysis(const FewBodyAnalysis&) = default;
    FewBodyAnalysis& operator=(const FewBodyAnalysis&) = default;
};

/// The system that an analysis is applied to.
struct FewBodyTarget {
    Index bodies;
    int dimensions;
    const ChosenFewBodyForce& force;
};

/// The options of an analysis of few bodies, see Description.
class FewBodyAnalysisOptions {
  public:
    virtual ~FewBodyAnalysisOptions() = default;
    virtual void describe(Description& /*description*/) {}
    [[nodiscard]] virtual Misfits check(const FewBodyTarget& target) const = 0;
    [[nodiscard]] virtual std::unique_ptr<FewBodyAnalysis> make(const FewBodyTarget& target) const = 0;

  protected:
    FewBodyAnalysisOptions() = default;
    FewBodyAnalysisOptions(const FewBodyAnalysisOptions&) = default;
    FewBodyAnalysisOptions& operator=(const FewBodyAnalysisOptions&) = default;
};

/// A few-body analysis, as [analysis] of a few-body deck selects it. Each is one file in
/// src/observables/few_body_analyses.
struct FewBodyAnalysisMethod {
    std::string name;  ///< the key in [analysis]
    std::string meaning;
    std::function<std::unique_ptr<FewBodyAnalysisOptions>()> options;  ///< at their defaults
};

/// All few-body analyses, in alphabetical order.
[[nodiscard]] std::vector<FewBodyAnalysisMethod> all_few_body_analyses();

/// The analysis of a choice with its options. @throws InputError see chosen()
[[nodiscard]] Chosen<FewBodyAnalysisMethod, FewBodyAnalysisOptions> chosen_few_body_analysis(const Choice& choice);

}  // namespace ljmd
