#pragma once

#include <memory>
#include <vector>

#include "engine/few_body_measurement.hpp"
#include "engine/few_body_spec.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A run of few bodies in memory: what Simulation is for a fluid.
///
/// The same specification gives the same trajectory, to the last bit, as a deck that says the same.
class FewBodySimulation {
  public:
    /// @pre the specification makes sense: it comes from a deck  @throws as make_few_body_system()
    explicit FewBodySimulation(FewBodySpec spec, const Execution& execution = {});
    ~FewBodySimulation();
    FewBodySimulation(FewBodySimulation&&) noexcept;
    FewBodySimulation& operator=(FewBodySimulation&&) noexcept;
    FewBodySimulation(const FewBodySimulation&) = delete;
    FewBodySimulation& operator=(const FewBodySimulation&) = delete;

    /// Take some steps; fewer if the stages end before. The first call also evaluates the start.
    /// @throws PhysicsError naming step and stage, when the run blows up
    void advance(Index steps);

    [[nodiscard]] bool finished() const;

    /// Results so far. @pre advance() was called
    [[nodiscard]] FewBodyResult result() const;

    [[nodiscard]] const FewBodySpec& spec() const;
    [[nodiscard]] const State& state() const;

    /// All samples: of the start, and then every `sample_every` steps. At the end of the run there is one more if it
    /// has none.
    [[nodiscard]] const std::vector<FewBodyRow>& samples() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ljmd
