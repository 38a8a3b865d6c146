#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/description.hpp"
#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/few_body/polar_angle.hpp"

namespace ljmd {

/// The end of one step, the deck's or one that an adaptive integrator takes within it, as an analysis sees it;
/// state.time is the time.
struct FewBodySample {
    const State& state;
    std::optional<PolarAngle> angle;  ///< of a force that has one beside its coordinate (radial-kepler)
};

/// A number that was found. Units are those of the deck; angles in rad.
struct Finding {
    std::string name;
    double value;                          ///< NaN where it has none
    std::optional<double> standard_error;  ///< of a mean over orbits or swings
    std::string remark = {};               ///< why it has no value
};

/// Something measured on a few bodies at every step of the sampled stages, and at those that an adaptive integrator
/// takes within them. Sampling never changes the state.
class FewBodyAnalysis {
  public:
    virtual ~FewBodyAnalysis() = default;

    virtual void sample(const FewBodySample& now) = 0;

    /// What has been found so far; what cannot be told yet is left out.
    [[nodiscard]] virtual std::vector<Finding> findings() const = 0;

    /// Single events, for a file of their own.
    [[nodiscard]] virtual std::optional<DataTable> table() const = 0;

    /// All that sampling has changed.
    /// @param now  from which it goes on  @throws CheckpointError when that cannot be
    virtual void archive(Archive& a, const State& now) = 0;

  protected:
    FewBodyAnalysis() = default;
    FewBodyAnalysis(const FewBodyAnalysis&) = default;
    FewBodyAnalysis& operator=(const FewBodyAnalysis&) = default;
};

/// What an analysis is asked to look at.
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

/// A kind of analysis that [analysis] of a few-body deck can ask for. One file in src/observables/few_body_analyses
/// each.
struct FewBodyAnalysisMethod {
    std::string name;  ///< the key in [analysis]
    std::string meaning;
    std::function<std::unique_ptr<FewBodyAnalysisOptions>()> options;  ///< at their defaults
};

/// Every few-body analysis there is, in alphabetical order.
[[nodiscard]] std::vector<FewBodyAnalysisMethod> all_few_body_analyses();

}  // namespace ljmd
