#include "ljmd/engine/simulation.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <span>

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
    for (const std::string& mistake : mistakes(spec, execution.precision())) {
        text += (text.empty() ? "" : "\n") + mistake;
    }
    if (!text.empty()) {
        throw InputError(text);
    }
    return spec;
}

/// The specification with the seed in all stages that have none.
FluidSpec seeded(FluidSpec spec) {
    for (Stage& stage : spec.stages) {
        stage.seed = stage.seed == 0 ? spec.seed : stage.seed;
    }
    return spec;
}

/// Everything of a specification that the trajectory and the results depend on but for the atoms, as text. Two
/// specifications with the same text continue each other's runs.
std::string identity(const FluidSpec& spec, const Execution& execution) {
    std::string text = fmt::format("{} {} {} {}", spec.potential.formula(), spec.potential.truncation(),
                                   spec.potential.cutoff().radius, spec.potential.cutoff().switch_start);
    for (const auto& [key, value] : spec.potential.parameters()) {
        text += fmt::format(" {}={}", key, value);
    }
    text += fmt::format("; {}; {} {} {}; {}; {} {}", spec.tail, spec.neighbors.method, spec.neighbors.skin,
                        spec.neighbors.every.value_or(0), spec.sample_every, spec.seed, name(execution.precision()));
    for (const Stage& stage : spec.stages) {
        text += fmt::format("; stage {} {} {} {} {} {} {} {} {}", stage.name, stage.integrator.plugin.name,
                            stage.integrator.values, stage.time_step, stage.steps, stage.temperature, stage.sample,
                            stage.reverse, stage.seed);
        if (stage.thermostat) {
            text += fmt::format(" {} {}", stage.thermostat->plugin.name, stage.thermostat->values);
        }
        if (stage.barostat) {
            text += fmt::format(" {} {}", stage.barostat->plugin.name, stage.barostat->values);
        }
    }
    for (const ChosenAnalysis& analysis : spec.analyses) {
        text += fmt::format("; {} {}", analysis.plugin.name, analysis.values);
    }
    return text;
}

/// Bytes of the hash at the end of a checkpoint.
constexpr std::size_t hash_bytes = sizeof(XXH64_hash_t);

}  // namespace

/// Parts point to each other, so they stay where they are.
struct Simulation::Parts {
    Parts(FluidSpec wanted, const Execution& execution)
        : spec(seeded(std::move(wanted))),
          fluid(make_fluid(checked(spec, execution), execution,
                           [this](const std::string& text) { warnings.push_back(text); })),
          measurement(std::in_place, spec, fluid, rows) {}

    void advance(std::optional<Index> until) {
        require_sound();
        failed = true;  // unless this comes to its end
        position =
            run_stages(spec.stages, fluid.state, fluid.force_field, *measurement, position, spec.interaction(), until);
        failed = false;
    }

    /// @throws ContractViolation after a step or a restore that failed
    void require_sound() const {
        if (failed) {
            throw ContractViolation("this simulation has failed, and cannot be continued");
        }
    }

    void read(Archive& a) {
        failed = true;
        a.mark("ljmd simulation");
        std::string of;
        Vec3 edges;
        a(of, position, edges);
        if (of != identity(spec, fluid.state.execution())) {
            throw CheckpointError("the checkpoint belongs to a simulation with another specification");
        }
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
        failed = false;
    }

    FluidSpec spec;
    std::vector<std::string> warnings;
    Rows rows;
    FluidSystem fluid;
    std::optional<FluidMeasurement> measurement;
    std::optional<LoopPosition> position;  ///< empty until the first step
    bool failed = false;                   ///< a step or a restore has not come to its end
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
    const Index left = total_steps(parts_->spec.stages) - parts_->fluid.state.step;
    parts_->advance(parts_->fluid.state.step + std::min(steps, left));
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
    parts_->require_sound();
    Archive a;
    a.mark("ljmd simulation");
    std::string of = identity(parts_->spec, state().execution());
    Vec3 edges = state().box().edges();
    a(of, parts_->position, edges);
    parts_->measurement->archive(a);
    const XXH64_hash_t hash = XXH3_64bits(a.bytes().data(), a.bytes().size());
    std::string bytes(a.bytes().size() + hash_bytes, '\0');
    std::memcpy(bytes.data(), a.bytes().data(), a.bytes().size());
    std::memcpy(bytes.data() + a.bytes().size(), &hash, hash_bytes);
    return bytes;
}

void Simulation::restore(const std::string& checkpoint) {
    const std::size_t size = checkpoint.size() - std::min(checkpoint.size(), hash_bytes);
    const XXH64_hash_t hash = XXH3_64bits(checkpoint.data(), size);
    if (size == 0 || std::memcmp(&hash, checkpoint.data() + size, hash_bytes) != 0) {
        throw CheckpointError("the checkpoint is damaged");
    }
    Archive a(std::as_bytes(std::span(checkpoint)).first(size));
    parts_->read(a);
}

}  // namespace ljmd
