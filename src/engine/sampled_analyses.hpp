#pragma once

#include <vector>

#include "engine/fluid_system.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/engine/observer.hpp"
#include "ljmd/engine/run_result.hpp"

namespace ljmd {

/// The analyses of a fluid and the observers of a program: when they are due, what they need, and their samples.
class SampledAnalyses {
  public:
    /// All must live as long as this. @throws InputError as add()
    SampledAnalyses(const FluidSpec& spec, FluidSystem& fluid, const std::vector<Observer*>& observers);

    /// Let an observer measure from now on. @throws InputError if it does already
    void add(Observer& observer);
    [[nodiscard]] const std::vector<Observer*>& observers() const { return observers_; }

    /// A stage begins: what is correlated in time begins anew. Before their first sample the analyses are made again
    /// if the box is another than they were made for.
    /// @throws PhysicsError if they do not fit into the box that a barostat has made
    void stage_begins(const Stage& stage);

    /// Whether a sample at this step of the run reads the potential energy.
    [[nodiscard]] bool want_energy(Index step) const;

    /// Whether there is a sample at this step.
    [[nodiscard]] bool are_due(Index step) const;

    /// Let those that are due take their sample.
    /// @param energy_known  of the evaluation  @param always  all take one
    void sample(const Evaluation& evaluation, bool energy_known, bool always);

    /// Append tables and averages of the analyses.
    void add_to(RunResult& result) const;

    /// Append the averages of the observers.
    void add_observed_to(RunResult& result) const;

    /// @throws CheckpointError for another number of observers
    void archive(Archive& a);

  private:
    void adapt();

    const FluidSpec& spec_;
    FluidSystem& fluid_;
    std::vector<Observer*> observers_;
    Vec3 edges_;  ///< of the box that the analyses were made for
};

}  // namespace ljmd
