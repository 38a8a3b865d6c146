#include "engine/few_body_simulation.hpp"

#include <algorithm>
#include <utility>

#include "engine/few_body_system.hpp"

namespace ljmd {

namespace {

class Rows : public RunOutputs {
  public:
    using RunOutputs::row;
    void row(const FewBodyRow& row) override { all.push_back(row); }

    std::vector<FewBodyRow> all;
};

}  // namespace

/// Parts point to each other, so they stay where they are.
struct FewBodySimulation::Parts {
    Parts(FewBodySpec wanted, const Execution& execution)
        : spec(std::move(wanted)),
          system(make_few_body_system(spec, execution)),
          measurement(spec.stages, spec.sample_every, system, rows) {}

    [[nodiscard]] bool finished() const { return position && position->stage == spec.stages.size(); }

    FewBodySpec spec;
    Rows rows;
    FewBodySystem system;
    FewBodyMeasurement measurement;
    std::optional<LoopPosition> position;  ///< empty until the first step
};

FewBodySimulation::FewBodySimulation(FewBodySpec spec, const Execution& execution)
    : parts_(std::make_unique<Parts>(std::move(spec), execution)) {}
FewBodySimulation::~FewBodySimulation() = default;
FewBodySimulation::FewBodySimulation(FewBodySimulation&&) noexcept = default;
FewBodySimulation& FewBodySimulation::operator=(FewBodySimulation&&) noexcept = default;

void FewBodySimulation::advance(Index steps) {
    Parts& p = *parts_;
    if (p.finished()) {
        return;
    }
    const Index done = p.system.state.step;
    const Index until = done + std::min(steps, total_steps(p.spec.stages) - done);
    p.position = run_stages(p.spec.stages, p.system.state, *p.system.force_field, p.measurement, p.position,
                            std::nullopt, until);
    if (p.finished()) {
        p.measurement.record_end();
    }
}

bool FewBodySimulation::finished() const {
    return parts_->finished();
}

FewBodyResult FewBodySimulation::result() const {
    return parts_->measurement.result(parts_->position ? parts_->position->seconds : LoopSeconds{});
}

const FewBodySpec& FewBodySimulation::spec() const {
    return parts_->spec;
}

const State& FewBodySimulation::state() const {
    return parts_->system.state;
}

const std::vector<FewBodyRow>& FewBodySimulation::samples() const {
    return parts_->rows.all;
}

}  // namespace ljmd
