#include "ljmd/engine/stage.hpp"

#include <algorithm>

#include "ljmd/core/errors.hpp"

namespace ljmd {

bool conserves_energy(const Stage& stage) {
    return !stage.barostat && (!stage.thermostat || stage.thermostat->plugin.canonical);
}

Index total_steps(const std::vector<Stage>& stages) {
    return steps_before(stages, stages.size());
}

Index steps_before(const std::vector<Stage>& stages, std::size_t index) {
    Index sum = 0;
    for (std::size_t k = 0; k < index; ++k) {
        sum += stages[k].steps;
    }
    return sum;
}

std::size_t first_sampled(const std::vector<Stage>& stages) {
    if (stages.empty()) {
        throw InputError("a run has at least one stage");
    }
    const auto first = std::ranges::find_if(stages, &Stage::sample);
    return static_cast<std::size_t>((first == stages.end() ? first - 1 : first) - stages.begin());
}

}  // namespace ljmd
