#include "ljmd/engine/few_body_simulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <utility>

#include "engine/few_body_measurement.hpp"
#include "engine/few_body_system.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Keeps rows, and passes rows and frames on to who wants them.
class Rows : public RunOutputs {
  public:
    explicit Rows(RunOutputs* also) : also_(also) {}

    using RunOutputs::row;
    void row(const FewBodyRow& row) override {
        all.push_back(row);
        if (also_ != nullptr) {
            also_->row(row);
        }
    }
    [[nodiscard]] bool frame_is_due(const State& state) const override {
        return also_ != nullptr && also_->frame_is_due(state);
    }
    void frame(const State& state, const std::optional<double>& angle) override {
        if (also_ != nullptr) {
            also_->frame(state, angle);
        }
    }

    std::vector<FewBodyRow> all;

  private:
    RunOutputs* also_;
};

FewBodySpec checked(FewBodySpec spec) {
    if (const std::vector<std::string> found = mistakes(spec); !found.empty()) {
        throw InputError(fmt::format("{}", fmt::join(found, "\n")));
    }
    return spec;
}

}  // namespace

/// Parts point to each other, so they stay where they are.
struct FewBodySimulation::Parts {
    Parts(FewBodySpec wanted, const Execution& execution, RunOutputs* outputs)
        : spec(checked(std::move(wanted))),
          rows(outputs),
          system(make_few_body_system(spec, execution)),
          measurement(spec.stages, spec.sample_every, system, rows) {}

    [[nodiscard]] bool finished() const { return position && position->stage == spec.stages.size(); }

    FewBodySpec spec;
    Rows rows;
    FewBodySystem system;
    FewBodyMeasurement measurement;
    std::optional<LoopPosition> position;  ///< empty until the first step
    bool failed = false;
};

FewBodySimulation::FewBodySimulation(FewBodySpec spec, const Execution& execution, RunOutputs* outputs)
    : parts_(std::make_unique<Parts>(std::move(spec), execution, outputs)) {}
FewBodySimulation::~FewBodySimulation() = default;
FewBodySimulation::FewBodySimulation(FewBodySimulation&&) noexcept = default;
FewBodySimulation& FewBodySimulation::operator=(FewBodySimulation&&) noexcept = default;

FewBodySimulation::Parts& FewBodySimulation::parts() const {
    if (!parts_) {
        throw InputError("this simulation has been moved to another one");
    }
    return *parts_;
}

FewBodyResult FewBodySimulation::run() {
    advance(total_steps(parts().spec.stages));
    return result();
}

void FewBodySimulation::advance(Index steps) {
    if (steps < 0) {
        throw InputError(fmt::format("{} steps: allowed are 0 and more", steps));
    }
    Parts& p = parts();
    if (p.failed) {
        throw InputError("this simulation has failed: it can be looked at, not continued");
    }
    if (p.finished()) {
        return;
    }
    p.failed = true;  // unless all goes well
    const Index done = p.system.state.step;
    const bool to_the_end = steps >= total_steps(p.spec.stages) - done;  // also through stages without steps
    const std::optional<Index> until = to_the_end ? std::nullopt : std::optional(done + steps);
    try {
        p.position = run_stages(p.spec.stages, p.system.state, *p.system.force_field, p.measurement.party(), p.position,
                                std::nullopt, until);
        if (p.finished()) {
            p.measurement.record_end();
        }
    } catch (...) {
        p.system.state.finish_kick();  // so that the state can be looked at
        throw;
    }
    p.failed = false;
}

bool FewBodySimulation::finished() const {
    return parts().finished();
}

FewBodyResult FewBodySimulation::result() const {
    const Parts& p = parts();
    if (!p.position) {
        throw InputError("results of few bodies are known after the first call of run() or advance()");
    }
    return p.measurement.result(p.position->seconds);
}

const FewBodySpec& FewBodySimulation::spec() const {
    return parts().spec;
}

const State& FewBodySimulation::state() const {
    return parts().system.state;
}

const std::vector<FewBodyRow>& FewBodySimulation::samples() const {
    return parts().rows.all;
}

}  // namespace ljmd
