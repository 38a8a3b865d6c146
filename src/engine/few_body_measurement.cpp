#include "engine/few_body_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ljmd/core/errors.hpp"
#include "model/checksum.hpp"

namespace ljmd {

namespace {

std::vector<std::pair<std::string, double>> named(const FewBodyTotals& totals, int dimensions) {
    std::vector<std::pair<std::string, double>> values{{"potential_energy", totals.potential_energy},
                                                       {"kinetic_energy", totals.kinetic_energy},
                                                       {"total_energy", totals.total_energy}};
    for (int a = 0; a < dimensions; ++a) {
        values.emplace_back(fmt::format("momentum_{}", "xyz"[a]), totals.momentum[a]);
    }
    for (int a = dimensions == 2 ? 2 : 0; a < 3 && dimensions >= 2; ++a) {
        values.emplace_back(fmt::format("angular_momentum_{}", "xyz"[a]), totals.angular_momentum[a]);
    }
    return values;
}

}  // namespace

FewBodyMeasurement::FewBodyMeasurement(const std::vector<Stage>& stages, Index sample_every, FewBodySystem& system,
                                       RunOutputs& outputs)
    : all_stages_(stages), sample_every_(sample_every), system_(system), outputs_(outputs) {}

void FewBodyMeasurement::archive(Archive& a) {
    a(system_.state);
    system_.force_field->archive(a, system_.state);
    a.mark("averages");
    a(quadrature_, angle_, sense_of_angle_, sampling_, rows_, histories_, drift_, stages_);
    a.mark("analyses");
    for (const auto& [name, analysis] : system_.analyses) {
        analysis->archive(a, system_.state);
    }
}

void FewBodyMeasurement::require_begun(const LoopPosition& position) const {
    require_stages(stages_, all_stages_, position);
    const auto begun = all_stages_.begin();
    const auto values = named(few_body_totals(system_.state, 0.0), system_.dimensions);
    const bool wanted =
        std::any_of(begun, begun + std::ssize(stages_), [](const Stage& stage) { return stage.sample; });
    const bool same =
        sampling_ == wanted &&
        std::equal(histories_.begin(), histories_.end(), values.begin(), values.end(),
                   [](const FewBodyHistory& history, const auto& value) { return history.name == value.first; });
    if (!same || rows_ < 0 || rows_ > system_.state.step + 1) {
        throw CheckpointError("the checkpoint has samples of other stages than the run");
    }
}

bool FewBodyMeasurement::wants_checkpoint(bool last_of_stage) {
    return outputs_.checkpoint_is_due(system_.state.step, last_of_stage);
}

void FewBodyMeasurement::checkpoint(const LoopPosition& position) {
    require_finite();  // a checkpoint after a blow-up would be useless
    outputs_.checkpoint(system_.state, position, [this](Archive& a) { archive(a); });
}

void FewBodyMeasurement::started(const Evaluation& evaluation) {
    add_angle(system_.state);
    record(evaluation);
    outputs_.frame(system_.state, angle());
}

void FewBodyMeasurement::stage_begins(const Stage& stage) {
    outputs_.stage_begins(stage);
    const State& state = system_.state;
    if (stage.sample && !sampling_) {  // sampled stages follow one another, see few_body_sampling_mistakes()
        sampling_ = true;
        sample(state);
    }
    if (stage.reverse) {
        sense_of_angle_ = -sense_of_angle_;  // the velocities are reversed after this
        if (angle_) {
            angle_ = quadrature_.turn_round();
        }
    }
    drift_ = {};
    stages_.push_back(begun_stage(stage, state, false));
}

bool FewBodyMeasurement::looks_within_steps(const Stage& stage) const {
    return system_.force.plugin.has_polar_angle || (stage.sample && !system_.analyses.empty());
}

void FewBodyMeasurement::within_step(const Stage& stage, const State& moment) {
    add_angle(moment);
    if (stage.sample) {
        sample(moment);
    }
}

void FewBodyMeasurement::step_done(const Stage& stage, const Evaluation& evaluation) {
    const State& state = system_.state;
    add_angle(state);
    if (wants_energy(state.step)) {
        record(evaluation);
    }
    if (stage.sample) {
        sample(state);
    }
    if (outputs_.frame_is_due(state)) {
        outputs_.frame(state, angle());
    }
    outputs_.step_done(state.step);
}

void FewBodyMeasurement::stage_ends(const Stage& /*stage*/) {
    StageResult& stage = stages_.back();
    stage.last_step = system_.state.step;
    stage.energy_drift = drift_.slope();
    stage.checksum_at_end = checksum(system_.state);
}

void FewBodyMeasurement::record_end() {
    State& state = system_.state;
    if (sample_every_.due(state.step)) {
        return;
    }
    try {
        record(system_.force_field->evaluate(state, Request::forces_and_energy));
    } catch (const PhysicsError& error) {
        throw PhysicsError(fmt::format("step {}: {}", state.step, error.what()));
    }
    stages_.back().energy_drift = drift_.slope();
}

/// @throws PhysicsError when a body has a position or velocity that is not finite
void FewBodyMeasurement::require_finite() const {
    const State& state = system_.state;
    for (Index i = 0; i < state.count(); ++i) {
        if (!state.positions().col(i).allFinite() || !std::isfinite(state.velocities().col(i).squaredNorm())) {
            throw PhysicsError(
                fmt::format("body {} was pushed out of the range of numbers: the run has blown up. Is the time "
                            "step too large, or do bodies come too close?",
                            i + 1));
        }
    }
}

void FewBodyMeasurement::add_angle(const State& state) {
    if (system_.force.plugin.has_polar_angle) {
        const auto [rate, slope] =
            system_.force.options->angular_velocity(state.positions()(0, 0), state.velocities()(0, 0));
        angle_ = quadrature_.add(state.time, sense_of_angle_ * rate, sense_of_angle_ * slope);
    }
}

std::optional<double> FewBodyMeasurement::angle() const {
    return angle_ ? std::optional(angle_->value) : std::nullopt;
}

void FewBodyMeasurement::sample(const State& state) {
    for (const auto& [name, analysis] : system_.analyses) {
        analysis->sample({state, angle_});
    }
}

void FewBodyMeasurement::record(const Evaluation& evaluation) {
    const State& state = system_.state;
    require_finite();
    const FewBodyTotals totals = few_body_totals(state, evaluation.potential_energy);
    if (!std::isfinite(totals.total_energy)) {
        throw PhysicsError(
            fmt::format("the total energy is {} now: the run has blown up. Is the time step too large, or do "
                        "bodies come too close?",
                        totals.total_energy));
    }
    outputs_.row(FewBodyRow{state.step, state.time, totals});
    drift_.add(state.time, totals.total_energy);
    ++rows_;
    const auto values = named(totals, system_.dimensions);
    if (histories_.empty()) {
        for (const auto& [name, value] : values) {
            histories_.push_back({name, value, value, 0.0, 0.0});
        }
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        FewBodyHistory& history = histories_[k];
        history.at_end = values[k].second;
        history.mean += (values[k].second - history.mean) / static_cast<double>(rows_);
        history.largest_deviation = std::max(history.largest_deviation, std::abs(values[k].second - history.at_start));
    }
}

FewBodyResult FewBodyMeasurement::result(const LoopSeconds& loop) const {
    FewBodyResult result{.bodies = system_.state.count(),
                         .dimensions = system_.dimensions,
                         .force = system_.force.plugin.name,
                         .histories = histories_,
                         .stages = stages_,
                         .findings = {},
                         .tables = {},
                         .seconds = loop.all};
    for (const auto& [name, analysis] : system_.analyses) {
        result.findings.emplace_back(name, analysis->findings());
        if (const auto table = analysis->table()) {
            result.tables.push_back(*table);
        }
    }
    return result;
}

}  // namespace ljmd
