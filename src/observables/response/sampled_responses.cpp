#include "observables/response/sampled_responses.hpp"

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"
#include "observables/pair_curvature.hpp"

namespace ljmd {

SampledResponses::SampledResponses(const SampledRun& run, Every every)
    : interaction_(run.interaction.value()),
      every_(every),
      responses_(run.atoms, run.ensemble, run.held_pressure, true) {}

void SampledResponses::sample(const State& state, const Evaluation& evaluation) {
    const auto atoms = static_cast<double>(state.count());
    const double volume = state.box().volume() / atoms;
    const double tail = interaction_.tail.pressure(1.0 / volume);
    const PairCurvature curvature = pair_curvature(state, interaction_.potential);
    responses_.add({temperature(state).value_or(0.0), curvature.energy / atoms + tail * volume,
                    virial_pressure(state, evaluation, interaction_.tail), volume,
                    curvature.hypervirial / (9.0 * atoms * volume) + tail});
}

}  // namespace ljmd
