#include "ljmd/engine/simulation.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/engine/fluid_measurement.hpp"
#include "ljmd/engine/fluid_system.hpp"

namespace ljmd {

namespace {

class Rows : public RunOutputs {
  public:
    using RunOutputs::row;
    void row(const ThermoRow& row) override { all.push_back(row); }

    std::vector<ThermoRow> all;
};

const FluidSpec& checked(const FluidSpec& spec, const Execution& execution) {
    std::string text;
    for (const std::string& mistake : mistakes(spec)) {
        text += (text.empty() ? "" : "\n") + mistake;
    }
    if (execution.precision() == Precision::mixed && spec.neighbors.method != "verlet-list") {
        text += (text.empty() ? "" : "\n") + std::string("neighbors: mixed precision needs the method verlet-list");
    }
    if (!text.empty()) {
        throw InputError(text);
    }
    return spec;
}

}  // namespace

/// Parts point to each other, so they stay where they are.
struct Simulation::Parts {
    Parts(FluidSpec wanted, const Execution& execution)
        : spec(std::move(wanted)),
          fluid(make_fluid(checked(spec, execution), execution,
                           [this](const std::string& text) { warnings.push_back(text); })),
          measurement(std::in_place, spec, fluid, rows) {}

    void advance(std::optional<Index> until) {
        position =
            run_stages(spec.stages, fluid.state, fluid.force_field, *measurement, position, spec.interaction(), until);
    }

    void read(Archive& a) {
        a.mark("ljmd simulation");
        Vec3 edges;
        a(position, edges);
        if (position && position->stage > spec.stages.size()) {
            throw CheckpointError("the checkpoint is in a stage that the simulation does not have");
        }
        fluid = empty_fluid(spec, fluid.state.count(), Box(edges), fluid.state.execution());
        rows.all.clear();
        const std::vector<Observer*> observers = measurement->observers();
        measurement.emplace(spec, fluid, rows, observers);
        if (position) {
            measurement->resume_at(*position);
        }
        measurement->archive(a);
        a.expect_end();
        if (position) {
            measurement->require_begun(*position);
        }
    }

    FluidSpec spec;
    std::vector<std::string> warnings;
    Rows rows;
    FluidSystem fluid;
    std::optional<FluidMeasurement> measurement;
    std::optional<LoopPosition> position;  ///< empty until the first step
};

Simulation::Simulation(FluidSpec spec, const Execution& execution)
    : parts_(std::make_unique<Parts>(std::move(spec), execution)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::add(Observer& observer) {
    parts_->measurement->add(observer);
}

RunResult Simulation::run() {
    parts_->advance(std::nullopt);
    return result();
}

void Simulation::advance(Index steps) {
    if (steps < 0) {
        throw ContractViolation(fmt::format("{} steps", steps));
    }
    parts_->advance(parts_->fluid.state.step + steps);
}

bool Simulation::finished() const {
    return parts_->position && parts_->position->stage == parts_->spec.stages.size();
}

RunResult Simulation::result() const {
    return parts_->measurement->result(parts_->position ? parts_->position->seconds : LoopSeconds{});
}

const FluidSpec& Simulation::spec() const {
    return parts_->spec;
}

const State& Simulation::state() const {
    return parts_->fluid.state;
}

const std::vector<ThermoRow>& Simulation::samples() const {
    return parts_->rows.all;
}

const std::vector<std::string>& Simulation::warnings() const {
    return parts_->warnings;
}

std::string Simulation::checkpoint() const {
    Archive a;
    a.mark("ljmd simulation");
    Vec3 edges = state().box().edges();
    a(parts_->position, edges);
    parts_->measurement->archive(a);
    return {reinterpret_cast<const char*>(a.bytes().data()), a.bytes().size()};
}

void Simulation::restore(const std::string& checkpoint) {
    Archive a(std::as_bytes(std::span(checkpoint)));
    parts_->read(a);
}

}  // namespace ljmd
