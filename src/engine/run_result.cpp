#include "ljmd/engine/run_result.hpp"

#include "ljmd/core/errors.hpp"
#include "model/checksum.hpp"

namespace ljmd {

namespace {

/// The item of this name. @throws InputError naming all, if there is none
template <class Item>
const Item& named(const std::vector<Item>& items, const std::string& name, const std::string& what) {
    std::string all;
    for (const Item& item : items) {
        if (item.name == name) {
            return item;
        }
        all += (all.empty() ? "" : ", ") + item.name;
    }
    throw InputError("the run has no " + what + " '" + name + "'; it has: " + (all.empty() ? "none" : all));
}

}  // namespace

StageResult begun_stage(const Stage& stage, const State& state, bool thermostatted) {
    return {
        stage.name,    stage.integrator.name, state.step,      state.step, stage.time_step, stage.sample, thermostatted,
        stage.reverse, std::nullopt,          checksum(state), {}};
}

void require_stages(const std::vector<StageResult>& results, const std::vector<Stage>& stages,
                    const LoopPosition& position) {
    bool same = results.size() == position.stage + (position.begun ? 1 : 0);
    for (std::size_t k = 0; same && k < results.size(); ++k) {
        same = results[k].name == stages[k].name && results[k].integrator == stages[k].integrator.name;
    }
    if (!same) {
        throw CheckpointError("the checkpoint has results of other stages than the run");
    }
}

const ObservableAverage& RunResult::observable(const std::string& name) const {
    return named(averages, name, "observable");
}

const DataTable& RunResult::table(const std::string& name) const {
    return named(tables, name, "table");
}

}  // namespace ljmd
