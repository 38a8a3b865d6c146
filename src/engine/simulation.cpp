#include "ljmd/engine/simulation.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "engine/fluid_measurement.hpp"
#include "engine/fluid_system.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/options/choice.hpp"
#include "options/placed.hpp"
#include "options/toml_writer.hpp"
#include "potentials/potential_identity.hpp"

namespace ljmd {

namespace {

class Rows : public RunOutputs {
  public:
    using RunOutputs::row;
    void row(const ThermoRow& row) override { all.push_back(row); }

    std::vector<ThermoRow> all;
};

FluidSpec checked(FluidSpec spec, const Execution& execution) {
    require_no_mistakes(spec, execution.precision());
    return spec;
}

/// The specification with all that stages and analyses leave to it or to defaults.
FluidSpec resolved(FluidSpec spec) {
    spec.stages = resolved_stages(spec);
    spec.tail = spec.has_tail();
    for (Choice& analysis : spec.analyses) {
        analysis = choice_of(chosen_analysis(analysis));
    }
    return spec;
}

/// What options describe of themselves, as text.
template <class Options>
std::string in_words(const Options& options) {
    return toml_value({table_of(options), {}});
}

/// Everything of a specification that the trajectory and the results depend on but for the atoms, as text. Two
/// specifications with the same text continue each other's runs.
std::string identity(const FluidSpec& spec, const Execution& execution) {
    // All members are named, so that a new one does not compile until it is decided on. A checkpoint has the atoms,
    // their box and their velocities in place of the start; units are for messages alone.
    const auto& [start, density, start_temperature, keep_velocities, seed, potential, tail, neighbors, external, stages,
                 sample_every, analyses, units] = spec;
    std::string text = fmt::format("{}; {}; {}; {}; {} {}", ljmd::identity(potential), spec.has_tail(),
                                   in_words(neighbors), sample_every, seed, name(execution.precision()));
    for (const Stage& stage : stages) {
        text += fmt::format("; stage {} seed = {}", in_words(stage), stage.seed);
    }
    if (external) {
        text += fmt::format("; external force {}", external->name());
    }
    for (const Choice& analysis : analyses) {
        text += fmt::format("; {} {}", analysis.name, settings_in_words(analysis.settings));
    }
    return text;
}

/// Bytes of the hash at the end of a checkpoint.
constexpr std::size_t hash_bytes = sizeof(XXH64_hash_t);

}  // namespace

/// Parts point to each other, so they stay where they are.
struct Simulation::Parts {
    Parts(FluidSpec wanted, const Execution& execution)
        : spec(resolved(checked(std::move(wanted), execution))),
          fluid(make_fluid(spec, execution, [this](const std::string& text) { warnings.push_back(text); })),
          interaction(spec.interaction()),
          measurement(std::in_place, spec, fluid, rows) {}

    void advance(std::optional<Index> until) {
        require_sound();
        failed = true;  // unless this comes to its end
        try {
            position = run_stages(spec.stages, fluid.state, fluid.force_field, measurement->party(), position,
                                  interaction, until);
        } catch (...) {
            fluid.state.finish_kick();  // so that the state can be looked at
            throw;
        }
        failed = false;
    }

    /// @throws InputError after a step or a restore that failed
    void require_sound() const {
        if (failed) {
            throw InputError("this simulation has failed: it can be looked at, but not be continued");
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
        fluid = empty_fluid(spec, fluid.state.total(), Box(edges), fluid.state.execution());
        rows.all.clear();
        const std::vector<Observer*> observers = measurement->analyses().observers();
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
    std::optional<Interaction> interaction;  ///< made once: a tail may take a quadrature
    std::optional<FluidMeasurement> measurement;
    std::optional<LoopPosition> position;  ///< empty until the first step
    bool failed = false;                   ///< a step or a restore has not come to its end
};

Simulation::Simulation(FluidSpec spec, const Execution& execution)
    : parts_(std::make_unique<Parts>(std::move(spec), execution)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation::Parts& Simulation::parts() const {
    if (!parts_) {
        throw InputError("this simulation has been moved to another one");
    }
    return *parts_;
}

void Simulation::add(Observer& observer) {
    parts().measurement->analyses().add(observer);
}

RunResult Simulation::run() {
    parts().advance(std::nullopt);
    return result();
}

void Simulation::advance(Index steps) {
    if (steps < 0) {
        throw InputError(fmt::format("{} steps: allowed are 0 and more", steps));
    }
    const Index done = state().step;
    const bool to_the_end = steps >= total_steps(spec().stages) - done;  // also through stages without steps
    parts().advance(to_the_end ? std::nullopt : std::optional(done + steps));
}

bool Simulation::finished() const {
    return parts().position && parts().position->stage == parts().spec.stages.size();
}

RunResult Simulation::result() const {
    return parts().measurement->result(parts().position ? parts().position->seconds : LoopSeconds{});
}

const FluidSpec& Simulation::spec() const {
    return parts().spec;
}

const State& Simulation::state() const {
    return parts().fluid.state;
}

const std::vector<ThermoRow>& Simulation::samples() const {
    return parts().rows.all;
}

Thermodynamics Simulation::thermodynamics() const {
    if (!samples().empty() && samples().back().step == state().step) {
        return samples().back().values;
    }
    State copy = state();
    PairForceField force_field = make_force_field(spec(), copy.execution());
    const Evaluation evaluation = force_field.evaluate(copy, Request::forces_and_energy);
    return ljmd::thermodynamics(copy, evaluation, parts().fluid.tail);
}

const std::vector<std::string>& Simulation::warnings() const {
    return parts().warnings;
}

std::string Simulation::checkpoint() const {
    parts().require_sound();
    Archive a;
    a.mark("ljmd simulation");
    std::string of = identity(parts().spec, state().execution());
    Vec3 edges = state().box().edges();
    a(of, parts().position, edges);
    parts().measurement->archive(a);
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
    parts().read(a);
}

}  // namespace ljmd
