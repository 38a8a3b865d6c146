#include "judge/own_run.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "integrators/integrator.hpp"
#include "ljmd/detail/engine/time_loop.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

/// Vectors of a state by id.
template <class Vector>
std::vector<Vec3> by_id(const State& state, const Vector& vector) {
    std::vector<Vec3> result(static_cast<std::size_t>(state.count()));
    for (Index i = 0; i < state.count(); ++i) {
        result[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])] = vector(i);
    }
    return result;
}

std::vector<Vec3> forces_of(const State& state) {
    return by_id(state, [&](Index i) -> Vec3 { return state.forces().col(i); });
}

/// Samples the state between steps.
class Sampler : public StepObserver {
  public:
    Sampler(const State& state, const TailCorrection& tail, Index every, const Interruption& interruption)
        : state_(state), tail_(tail), every_(every), interruption_(interruption) {}

    [[nodiscard]] bool wants_energy(Index step) const override { return step % every_ == 0; }
    [[nodiscard]] bool reads_velocities(Index step) const override { return step % every_ == 0; }
    void step_done(const Stage&, const Evaluation& evaluation) override {
        if (interruption_.request()) {
            interruption_.stop_many_runs();
        }
        if (state_.step % every_ != 0) {
            return;
        }
        const auto atoms = static_cast<double>(state_.count());
        const double volume = state_.box().edges().prod();
        const double kinetic = kinetic_energy(state_);
        samples_.potential_energy.push_back(evaluation.potential_energy + atoms * tail_.energy(atoms / volume));
        samples_.kinetic_energy.push_back(kinetic);
        samples_.pressure.push_back((2.0 * kinetic + evaluation.virial.trace()) / (3.0 * volume) +
                                    tail_.pressure(atoms / volume));
        samples_.volume.push_back(volume);
    }

    RunSamples take() { return std::move(samples_); }

  private:
    const State& state_;
    TailCorrection tail_;
    Index every_;
    const Interruption& interruption_;
    RunSamples samples_;
};

}  // namespace

std::vector<Vec3> forces_at(const Fluid& fluid, const std::vector<Vec3>& positions, ForceField& force_field,
                            const Execution& execution) {
    State state(std::ssize(positions), Box(fluid.edges), execution);
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3& place = positions[static_cast<std::size_t>(i)];
        r.col(i) = state.snapped(place - state.box().crossings(place).cwiseProduct(fluid.edges));
    }
    state.wrap();
    force_field.evaluate(state, Request::forces);
    return forces_of(state);
}

void follow(const Fluid& fluid, ForceField& force_field, const Execution& execution, JudgedTrajectory& trajectory) {
    State state = state_of(fluid, execution);
    const Integrator method(find_integrator("velocity-verlet"), trajectory.time_step);
    force_field.evaluate(state, Request::forces_and_energy);
    method.prepare(state, force_field);
    Index done = 0;
    Motion last;  // at the step `done`, if it was asked for
    const auto motion_at = [&](Index step) {
        if (done == step && !last.positions.empty()) {
            return last;
        }
        for (; done < step; ++done) {
            method.step(state, force_field, Request::forces);
        }
        const State& now = state;
        last = {.positions = by_id(now, [&](Index i) -> Vec3 { return now.unwrapped(i); }),
                .velocities = by_id(now, [&](Index i) -> Vec3 { return now.velocities().col(i); })};
        return last;
    };
    for (std::size_t k = 0; k < trajectory.frames.size(); ++k) {
        JudgedFrame& frame = trajectory.frames[k];
        if (frame.step > 0) {
            // The frame before may have gone beyond it already.
            frame.before = k > 0 && trajectory.frames[k - 1].step == frame.step - 1
                               ? Motion{trajectory.frames[k - 1].our_positions, trajectory.frames[k - 1].our_velocities}
                               : motion_at(frame.step - 1);
        }
        Motion now = motion_at(frame.step);
        frame.our_positions = std::move(now.positions);
        frame.our_velocities = std::move(now.velocities);
        frame.our_forces = forces_of(state);
        frame.after = motion_at(frame.step + 1);
    }
    for (JudgedFrame& frame : trajectory.frames) {
        frame.forces_there = forces_at(fluid, frame.positions, force_field, execution);
    }
}

std::vector<OwnRow> own_rows(const Fluid& fluid, const TailCorrection& tail, ForceField& force_field,
                             const Execution& execution, double time_step, Index steps) {
    State state = state_of(fluid, execution);
    const Integrator method(find_integrator("velocity-verlet"), time_step);
    const auto atoms = static_cast<double>(state.count());
    const double volume = fluid.edges.prod();
    std::vector<OwnRow> rows;
    const auto add = [&](const Evaluation& evaluation) {
        const State& now = state;
        const double kinetic = kinetic_energy(now);
        const double power = now.velocities().cwiseProduct(now.forces()).sum();
        const double squares = now.forces().squaredNorm();
        // K of v + a t
        const auto kinetic_at = [&](double t) { return kinetic + t * power + 0.5 * t * t * squares; };
        rows.push_back(
            {.potential_energy = evaluation.potential_energy + atoms * tail.energy(atoms / volume),
             .kinetic_energy = kinetic,
             .kinetic_energy_before = kinetic_at(-0.5 * time_step),
             .kinetic_energy_after = kinetic_at(0.5 * time_step),
             .pressure = (2.0 * kinetic + evaluation.virial.trace()) / (3.0 * volume) + tail.pressure(atoms / volume)});
    };
    add(force_field.evaluate(state, Request::forces_and_energy));
    method.prepare(state, force_field);
    for (Index step = 0; step < steps; ++step) {
        add(method.step(state, force_field, Request::forces_and_energy));
    }
    return rows;
}

RunSamples own_run(const Problem& problem, const FluidSpec& spec, const Execution& execution,
                   const Interruption& interruption) {
    State state = state_of(problem.fluid, execution);
    PairForceField force_field = make_force_field(spec, execution);
    Sampler sampler(state, spec.interaction().tail, problem.thermo_every, interruption);
    run_stages({problem.stage}, state, force_field, {sampler}, std::nullopt, spec.interaction());
    return sampler.take();
}

double half_step_kinetic_energy(const Fluid& fluid, const std::vector<Vec3>& forces, double t) {
    double twice = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        twice += fluid.masses[i] * (fluid.velocities[i] + t / fluid.masses[i] * forces[i]).squaredNorm();
    }
    return 0.5 * twice;
}

void keep_common_rows(RunSamples& ours, Index every, RunSamples& theirs, const std::vector<Index>& steps) {
    static constexpr std::array columns{&RunSamples::potential_energy, &RunSamples::kinetic_energy,
                                        &RunSamples::pressure, &RunSamples::volume};
    const Index samples = std::ssize(ours.kinetic_energy);
    std::size_t rows = 0;
    for (const auto column : columns) {
        rows = std::max(rows, (theirs.*column).size());
    }
    const std::size_t skipped = steps.size() - rows;
    std::vector<std::size_t> of_ours;
    std::vector<std::size_t> of_theirs;
    for (std::size_t k = skipped; k < steps.size(); ++k) {
        if (steps[k] % every == 0 && steps[k] / every <= samples) {
            of_ours.push_back(static_cast<std::size_t>(steps[k] / every - 1));
            of_theirs.push_back(k - skipped);
        }
    }
    const auto keep = [](std::vector<double>& column, const std::vector<std::size_t>& kept) {
        if (!column.empty()) {
            std::vector<double> values;
            std::ranges::transform(kept, std::back_inserter(values), [&](std::size_t row) { return column[row]; });
            column = std::move(values);
        }
    };
    for (const auto column : columns) {
        keep(ours.*column, of_ours);
        keep(theirs.*column, of_theirs);
    }
}

}  // namespace ljmd
