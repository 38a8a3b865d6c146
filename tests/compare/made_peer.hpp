#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compare/peer.hpp"
#include "compare/point_comparison.hpp"
#include "compare/trajectory_comparison.hpp"
#include "forces/pair_force_field.hpp"
#include "model/velocities.hpp"
#include "physics/liquid.hpp"

namespace ljmd::test {

/// A fluid for comparisons: 108 atoms in a crystal at T = 0.7.
inline Fluid warm_crystal() {
    State state = crystal(3, 0.8442);
    draw_velocities(state, 0.7, 5);
    return fluid_of(state, PairPotential::lennard_jones("force-shifted", {2.5, 2.0}), false);
}

/// A peer that is ljmd itself, with mistakes made on purpose.
class MadePeer : public Peer {
  public:
    explicit MadePeer(const Fluid& f) : fluid(f) {}

    Fluid fluid;
    /// Moves the places of a frame.
    std::function<void(PeerFrame&)> spoil = [](PeerFrame&) {};
    /// What a sample is like at a step.
    std::function<Totals(Index)> totals = [](Index) { return Totals{}; };
    std::vector<PeerMethod> known{{"one", {"leapfrog", "velocity-verlet"}}, {"two", {"velocity-verlet"}}};

    [[nodiscard]] std::string name() const override { return "made"; }
    [[nodiscard]] std::vector<PeerMethod> methods() const override { return known; }

    [[nodiscard]] static std::unique_ptr<ForceField> force_field_of(const Fluid& fluid) {
        return std::make_unique<PairForceField>(fluid.potential, make_pair_search("all-pairs", 0.3));
    }

    [[nodiscard]] PeerPoint point() override { return point_of(fluid, *force_field_of(fluid)); }

    [[nodiscard]] std::vector<PeerFrame> follow(const std::string&, double time_step,
                                                const std::vector<Index>& steps) override {
        auto frames = ljmd::follow(fluid, *force_field_of(fluid), "velocity-verlet", time_step, steps);
        for (PeerFrame& frame : frames) {
            spoil(frame);
        }
        return frames;
    }

    void sample(double, Index steps, Index every, Index frame_every, const Visitor& visit) override {
        for (Index step = every; step <= steps; step += every) {
            const bool frame = frame_every > 0 && step % frame_every == 0;
            visit(step, totals(step), frame ? &fluid.positions : nullptr);
        }
    }

    [[nodiscard]] double seconds(double, Index steps) override { return 1e-3 * static_cast<double>(steps); }
};

}  // namespace ljmd::test
