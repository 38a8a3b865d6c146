#pragma once

#include <memory>
#include <vector>

#include "ljmd/detail/engine/few_body_result.hpp"
#include "ljmd/detail/engine/few_body_spec.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A run of few bodies in unbounded space, in memory: what Simulation is for a fluid.
///
///     FewBodySpec comet{.force = few_body_force("newtonian-gravity",
///                                               {{"gravitational_constant", 1.0}, {"central_mass", 1.0}}),
///                       .bodies = {{.mass = 1.0, .position = {1.0, 0.0}, .velocity = {0.0, 1.3}}}};
///     comet.stages = {{.name = "orbit", .time_step = 0.01, .steps = 10000, .sample = true}};
///     FewBodySimulation simulation(comet);
///     simulation.run();
///     const Vec3 place = simulation.state().positions().col(0);
///
/// The same specification gives the same trajectory, to the last bit, as a deck that says the same.
class FewBodySimulation {
  public:
    /// @param outputs  receives rows and frames, and must live as long as this; null: nobody
    /// @throws InputError with all mistakes of the specification
    explicit FewBodySimulation(FewBodySpec spec, const Execution& execution = {}, RunOutputs* outputs = nullptr);
    ~FewBodySimulation();
    FewBodySimulation(FewBodySimulation&&) noexcept;
    FewBodySimulation& operator=(FewBodySimulation&&) noexcept;
    FewBodySimulation(const FewBodySimulation&) = delete;
    FewBodySimulation& operator=(const FewBodySimulation&) = delete;

    /// Take all steps that are left.
    /// @throws PhysicsError naming step and stage, when the run blows up; it can be looked at then, but not be
    /// continued (InputError)
    FewBodyResult run();

    /// Take some steps; fewer if the stages end before. The first call also evaluates the start.
    /// @throws InputError for fewer than 0; as run()
    void advance(Index steps);

    [[nodiscard]] bool finished() const;

    /// Results so far. @throws InputError  before the first call of run() or advance()
    [[nodiscard]] FewBodyResult result() const;

    [[nodiscard]] const FewBodySpec& spec() const;
    [[nodiscard]] const State& state() const;

    /// All samples: of the start, and then every `sample_every` steps. At the end of the run there is one more if it
    /// has none.
    [[nodiscard]] const std::vector<FewBodyRow>& samples() const;

  private:
    struct Parts;
    /// @throws InputError if this was moved to another one
    [[nodiscard]] Parts& parts() const;

    std::unique_ptr<Parts> parts_;
};

}  // namespace ljmd
