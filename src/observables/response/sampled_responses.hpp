#pragma once

#include "core/schedule.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "observables/response/response_functions.hpp"

namespace ljmd {

/// Response functions of the configurations of a run, see ResponseFunctions.
///
/// They belong to the potential in which the atoms move: energies are counted from its value at the cutoff
/// (PairCurvature), which for `cut` is not the energy that a run reports. With a tail correction the fluid has the
/// energy whose derivative is p_tail = A rho^2, namely p_tail V, and -V dp_tail/dV = 2 p_tail.
class SampledResponses : public Analysis {
  public:
    /// @pre run.interaction is known
    SampledResponses(const SampledRun& run, Every every);

    [[nodiscard]] bool due(Index step) const override { return every_.due(step); }
    [[nodiscard]] bool needs_energy() const override { return true; }
    void sample(const State& state, const Evaluation& evaluation) override;
    [[nodiscard]] Index samples() const override { return responses_.samples(); }
    [[nodiscard]] std::vector<DataTable> tables() const override { return {}; }
    [[nodiscard]] std::vector<ObservableAverage> observables() const override { return responses_.observables(); }
    void archive(Archive& a) override { responses_.archive(a); }

  private:
    Interaction interaction_;
    Every every_;
    ResponseFunctions responses_;
};

}  // namespace ljmd
