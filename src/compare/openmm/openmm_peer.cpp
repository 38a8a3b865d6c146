#include <OpenMM.h>
#include <fmt/format.h>

#include <functional>
#include <utility>

#include "compare/openmm/linked_openmm.hpp"
#include "compare/openmm/openmm_system.hpp"
#include "core/stopwatch.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

const std::string leapfrog_method = "VerletIntegrator";
const std::string kick_drift_kick_method = "kick-drift-kick";

/// Steps before timing: the first ones build data structures.
constexpr int warm_up = 5;

std::unique_ptr<OpenMM::Integrator> make_integrator(const std::string& method, double time_step) {
    if (method == leapfrog_method) {
        auto verlet = std::make_unique<OpenMM::VerletIntegrator>(time_step);
        verlet->setIntegrationForceGroups(moving);
        return verlet;
    }
    if (method != kick_drift_kick_method) {
        throw ContractViolation(fmt::format("no method of OpenMM is called '{}'", method));
    }
    // f0: force of group 0 only.
    auto custom = std::make_unique<OpenMM::CustomIntegrator>(time_step);
    custom->addComputePerDof("v", "v+0.5*dt*f0/m");
    custom->addComputePerDof("x", "x+dt*v");
    custom->addComputePerDof("v", "v+0.5*dt*f0/m");
    custom->setIntegrationForceGroups(moving);
    return custom;
}

/// Integrator and context; the context is destroyed first.
struct Motion {
    std::unique_ptr<OpenMM::Integrator> integrator;
    std::unique_ptr<OpenMM::Context> context;
};

class OpenmmPeer : public Peer {
  public:
    OpenmmPeer(OpenmmFluid fluid, const OpenmmOptions& options)
        : fluid_(std::move(fluid)),
          options_(options),
          platform_(OpenMM::Platform::getPlatformByName(options.platform)),
          system_(openmm_system(fluid_, OpenmmForces::with_virial, options.epsilon)) {}

    [[nodiscard]] std::string name() const override {
        return fmt::format("OpenMM {} ({}{})", OpenMM::Platform::getOpenMMVersion(), options_.platform,
                           options_.platform == "CPU"
                               ? fmt::format(", {} thread{}", options_.threads, options_.threads == 1 ? "" : "s")
                               : "");
    }

    [[nodiscard]] std::vector<PeerMethod> methods() const override {
        return {{leapfrog_method, {"leapfrog", "velocity-verlet"}}, {kick_drift_kick_method, {"velocity-verlet"}}};
    }

    [[nodiscard]] PeerPoint point() override {
        return guarded<PeerPoint>([&] {
            const Motion motion = begin(kick_drift_kick_method, 1e-3);
            OpenMM::Context& context = *motion.context;
            const OpenMM::State state = context.getState(OpenMM::State::Energy | OpenMM::State::Forces, false, moving);
            PeerPoint point{totals(context, state), from_openmm(state.getForces())};
            if (fluid_.tail) {
                point.tail_energy = tail_energy();
            }
            return point;
        });
    }

    [[nodiscard]] std::vector<PeerFrame> follow(const std::string& method, double time_step,
                                                const std::vector<Index>& steps) override {
        return guarded<std::vector<PeerFrame>>([&] {
            const Motion motion = begin(method, time_step);
            std::vector<PeerFrame> frames;
            Index done = 0;
            for (const Index step : steps) {
                motion.integrator->step(static_cast<int>(step - done));
                done = step;
                const OpenMM::State state =
                    motion.context->getState(OpenMM::State::Positions | OpenMM::State::Energy, false, moving);
                frames.push_back(
                    {step, state.getPotentialEnergy(), state.getKineticEnergy(), from_openmm(state.getPositions())});
            }
            return frames;
        });
    }

    void sample(double time_step, Index steps, Index every, Index frame_every, const Visitor& visit) override {
        guarded<void>([&] {
            const Motion motion = begin(leapfrog_method, time_step);
            for (Index step = every; step <= steps; step += every) {
                motion.integrator->step(static_cast<int>(every));
                const bool frame = frame_every > 0 && step % frame_every == 0;
                const OpenMM::State state = motion.context->getState(
                    OpenMM::State::Energy | (frame ? OpenMM::State::Positions : 0), false, moving);
                const Totals row = totals(*motion.context, state);
                if (frame) {
                    const std::vector<Vec3> positions = from_openmm(state.getPositions());
                    visit(step, row, &positions);
                } else {
                    visit(step, row, nullptr);
                }
            }
        });
    }

    [[nodiscard]] double seconds(double time_step, Index steps) override {
        return guarded<double>([&] {
            const Motion motion = begin(leapfrog_method, time_step);
            const auto run = [&](Index count) {
                motion.integrator->step(static_cast<int>(count));
                // A platform may only have queued the steps; this waits for the last one.
                static_cast<void>(motion.context->getState(OpenMM::State::Positions));
            };
            run(warm_up);
            Stopwatch watch;
            run(steps);
            return watch.lap();
        });
    }

  private:
    /// @throws PhysicsError when OpenMM fails
    template <class Result, class F>
    Result guarded(const F& f) const {
        try {
            return f();
        } catch (const OpenMM::OpenMMException& error) {
            throw PhysicsError(fmt::format("{}: {}", name(), error.what()));
        }
    }

    [[nodiscard]] std::map<std::string, std::string> properties() const {
        std::map<std::string, std::string> properties;
        for (const std::string& property : platform_.getPropertyNames()) {
            if (property == "Threads") {
                properties[property] = std::to_string(options_.threads);
            } else if (property == "Precision") {
                properties[property] = "double";
            }
        }
        return properties;
    }

    /// A context at the fluid's moment.
    [[nodiscard]] Motion begin(const std::string& method, double time_step) const {
        Motion motion{make_integrator(method, time_step), nullptr};
        try {
            motion.context = std::make_unique<OpenMM::Context>(*system_, *motion.integrator, platform_, properties());
        } catch (const OpenMM::OpenMMException& error) {
            throw InputError(fmt::format("OpenMM's platform {} cannot be used: {}", options_.platform, error.what()));
        }
        motion.context->setPositions(openmm_vectors(fluid_.positions));
        motion.context->setVelocities(method == leapfrog_method
                                          ? half_step_velocities(*motion.context, fluid_, time_step)
                                          : openmm_vectors(fluid_.velocities));
        return motion;
    }

    /// @param state  of the context, with the energy of the moving force: its kinetic energy depends on the force
    /// group, too
    static Totals totals(const OpenMM::Context& context, const OpenMM::State& state) {
        const auto derivatives =
            context.getState(OpenMM::State::ParameterDerivatives, false, virial).getEnergyParameterDerivatives();
        return {state.getPotentialEnergy(), state.getKineticEnergy(), -derivatives.at(scale_parameter)};
    }

    /// The long-range correction per atom, always on the Reference platform: no other is precise enough for a
    /// difference of energies.
    [[nodiscard]] double tail_energy() const {
        const auto energy = [&](OpenmmForces forces) {
            const auto system = openmm_system(fluid_, forces, options_.epsilon);
            OpenMM::VerletIntegrator integrator(1e-3);
            OpenMM::Context context(*system, integrator, OpenMM::Platform::getPlatformByName("Reference"));
            context.setPositions(openmm_vectors(fluid_.positions));
            return context.getState(OpenMM::State::Energy).getPotentialEnergy();
        };
        return (energy(OpenmmForces::with_tail) - energy(OpenmmForces::alone)) /
               static_cast<double>(fluid_.positions.size());
    }

    OpenmmFluid fluid_;
    OpenmmOptions options_;
    OpenMM::Platform& platform_;
    std::unique_ptr<OpenMM::System> system_;
};

}  // namespace

std::unique_ptr<Peer> linked_openmm_peer(OpenmmFluid fluid, const OpenmmOptions& options) {
    return std::make_unique<OpenmmPeer>(std::move(fluid), options);
}

}  // namespace ljmd
