// ljmd against OpenMM in the same process: one configuration and trajectories, for every potential, state and path, and
// the mistakes that must not pass.
#include <map>
#include <tuple>
#include "catch.hpp"

#include "compare/openmm.hpp"
#include "compare/point_comparison.hpp"
#include "compare/trajectory_comparison.hpp"
#include "forces/every_potential.hpp"
#include "ljmd/detail/execution/simd.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

constexpr double argon_step = 0.004;

MakeForceField by(const PairPotential& potential, const std::string& search = "verlet-list",
                  const Execution& execution = {}) {
    return [=] { return std::make_unique<PairForceField>(potential, make_pair_search(search, 0.3), execution); };
}

PairPotential cut() {
    return PairPotential::lennard_jones("cut", {2.5, 2.0});
}

/// The liquid near the triple point, with another potential than it was made with.
Fluid triple_point(Index cells, const PairPotential& potential, bool tail = false) {
    return fluid_of(liquid(cells, 11, "cut"), potential, tail);
}

/// Makes starts, the same ones on all processors of a kind, see liquid().
std::unique_ptr<ForceField> portable() {
    return by(cut(), "verlet-list", Execution({.simd = SimdLevel::portable}))();
}

/// A fluid at another density and temperature, molten and equilibrated.
Fluid fluid_at(double density, double temperature) {
    State state = crystal(6, density);
    const auto force_field = portable();
    draw_velocities(state, 2.0 * temperature, 4);
    for (int block = 0; block < 40; ++block) {
        advance(state, *force_field, 0.004, 20);
        rescale_velocities(state, temperature);
    }
    remove_momentum(state);
    return fluid_of(state, cut(), false);
}

Fluid cold_crystal(Index cells) {
    State state = crystal(cells, 1.0);
    const auto force_field = portable();
    draw_velocities(state, 0.8, 4);
    advance(state, *force_field, 0.004, 500);
    return fluid_of(state, cut(), false);
}

std::vector<Check> point_checks(const Fluid& fluid, Peer& peer, const Agreement& agreement,
                                const MakeForceField& make) {
    return compare_points(point_of(fluid, *make()), peer.point(), fluid, agreement);
}

std::vector<Check> trajectory_checks(const Fluid& fluid, Peer& peer, const Agreement& agreement,
                                     const MakeForceField& make, const std::vector<Index>& steps) {
    return checks_of(compare_trajectories(fluid, make, peer, argon_step, steps), steps, agreement);
}

void require_all(const std::vector<Check>& checks) {
    REQUIRE_FALSE(checks.empty());
    for (const Check& check : checks) {
        INFO(check.name << ": " << check.value << ", allowed " << check.tolerance);
        CHECK(check.passed());
    }
}

bool any_failed(const std::vector<Check>& checks) {
    REQUIRE_FALSE(checks.empty());
    return !std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed(); });
}

/// A peer that is asked for the same again: what OpenMM has once computed is not computed anew.
class Remembering : public Peer {
  public:
    explicit Remembering(std::unique_ptr<Peer> peer) : peer_(std::move(peer)), point_(peer_->point()) {}
    [[nodiscard]] std::string name() const override { return peer_->name(); }
    [[nodiscard]] std::vector<PeerMethod> methods() const override { return peer_->methods(); }
    [[nodiscard]] PeerPoint point() override { return point_; }
    [[nodiscard]] std::vector<PeerFrame> follow(const std::string& method, double dt,
                                                const std::vector<Index>& steps) override {
        auto& frames = frames_[{method, dt, steps}];
        if (frames.empty()) {
            frames = peer_->follow(method, dt, steps);
        }
        return frames;
    }
    void sample(double dt, Index steps, Index every, Index frame_every, const Visitor& visit) override {
        peer_->sample(dt, steps, every, frame_every, visit);
    }
    [[nodiscard]] double seconds(double dt, Index steps) override { return peer_->seconds(dt, steps); }

  private:
    std::unique_ptr<Peer> peer_;
    PeerPoint point_;
    std::map<std::tuple<std::string, double, std::vector<Index>>, std::vector<PeerFrame>> frames_;
};

const std::vector<Index> short_steps{1, 10, 100, 200};
const std::vector<Index> every_step_judged{1, 10, 100, 200, 500};

Agreement doubles(const Fluid& fluid) {
    return double_agreement(situation_of(fluid, argon_step));
}

Agreement singles(const Fluid& fluid) {
    return single_agreement(situation_of(fluid, argon_step));
}

void check_crystal(Index cells) {
    const Fluid fluid = cold_crystal(cells);
    const auto peer = make_openmm_peer(fluid, {});
    Agreement crystals = doubles(fluid);
    crystals.positions.back().distance = 1e-8;
    require_all(point_checks(fluid, *peer, crystals, by(cut())));
    require_all(trajectory_checks(fluid, *peer, crystals, by(cut()), every_step_judged));
}

}  // namespace

TEST_CASE("a liquid of 864 atoms goes OpenMM's way, leapfrog and velocity Verlet, for 500 steps") {
    const Fluid fluid = triple_point(6, cut(), true);
    const auto peer = make_openmm_peer(fluid, {});
    require_all(point_checks(fluid, *peer, doubles(fluid), by(cut())));
    require_all(trajectory_checks(fluid, *peer, doubles(fluid), by(cut()), every_step_judged));
}

TEST_CASE("a crystal of 864 atoms stays as close to OpenMM's as crystals do", "[long]") {
    check_crystal(6);
}

TEST_CASE("a liquid of 4000 atoms goes OpenMM's way for 500 steps", "[long]") {
    const Fluid fluid = triple_point(10, cut());
    const auto peer = make_openmm_peer(fluid, {});
    require_all(point_checks(fluid, *peer, doubles(fluid), by(cut())));
    require_all(trajectory_checks(fluid, *peer, doubles(fluid), by(cut()), every_step_judged));
}

TEST_CASE("a crystal of 4000 atoms does, too", "[long]") {
    check_crystal(10);
}

TEST_CASE("every formula with every truncation agrees with OpenMM") {
    for (const PairPotential& potential : every_potential()) {
        INFO(potential.formula() << ", " << potential.truncation());
        const Fluid fluid = triple_point(6, potential, PairPotential::takes_tail(potential.truncation()));
        const auto peer = make_openmm_peer(fluid, {});
        const auto checks = point_checks(fluid, *peer, doubles(fluid), by(potential));
        CHECK(checks.size() == (fluid.tail ? 5 : 4));
        require_all(checks);
        require_all(trajectory_checks(fluid, *peer, doubles(fluid), by(potential), {1, 10, 100}));
    }
}

TEST_CASE("a gas-like and a hot fluid agree with OpenMM up to step 200") {
    for (const auto& [density, temperature] : {std::pair{0.45, 1.744}, std::pair{0.85, 2.889}}) {
        INFO(density << ", " << temperature);
        const Fluid fluid = fluid_at(density, temperature);
        const auto peer = make_openmm_peer(fluid, {});

        require_all(point_checks(fluid, *peer, doubles(fluid), by(cut())));
        require_all(trajectory_checks(fluid, *peer, doubles(fluid), by(cut()), short_steps));
    }
}

TEST_CASE("every way to the neighbours agrees with OpenMM") {
    const Fluid fluid = triple_point(6, cut());
    Remembering peer(make_openmm_peer(fluid, {}));
    for (const std::string search : {"all-pairs", "cells", "verlet-list"}) {
        INFO(search);
        require_all(point_checks(fluid, peer, doubles(fluid), by(cut(), search)));
        require_all(trajectory_checks(fluid, peer, doubles(fluid), by(cut(), search), {1, 10, 100}));
    }
}

TEST_CASE("kernels of every SIMD level agree with OpenMM, in double and in mixed precision") {
    const Fluid fluid = triple_point(6, cut());
    Remembering peer(make_openmm_peer(fluid, {}));
    for (const SimdLevel level : usable_simd_levels()) {
        INFO(name(level));
        const Execution in_double({.simd = level, .precision = Precision::double_precision});
        require_all(point_checks(fluid, peer, doubles(fluid), by(cut(), "verlet-list", in_double)));
        require_all(trajectory_checks(fluid, peer, doubles(fluid), by(cut(), "verlet-list", in_double), {1, 10, 100}));
        const Execution mixed({.simd = level, .precision = Precision::mixed});
        require_all(point_checks(fluid, peer, singles(fluid), by(cut(), "verlet-list", mixed)));
        require_all(trajectory_checks(fluid, peer, singles(fluid), by(cut(), "verlet-list", mixed), {1, 10, 100}));
    }
}

TEST_CASE("OpenMM's CPU platform agrees as far as single precision goes") {
    for (const std::string truncation : {"cut", "force-shifted", "switched"}) {
        INFO(truncation);
        const PairPotential potential = PairPotential::lennard_jones(truncation, {2.5, 2.0});
        const Fluid fluid = triple_point(6, potential);
        const auto peer = make_openmm_peer(fluid, {.platform = "CPU"});
        require_all(point_checks(fluid, *peer, singles(fluid), by(potential)));
        require_all(trajectory_checks(fluid, *peer, singles(fluid), by(potential), short_steps));
    }
}

TEST_CASE("velocities that are not shifted by half a step do not pass") {
    const Fluid fluid = triple_point(6, cut());
    // The shift that the peer makes takes this one back.
    Fluid unshifted = fluid;
    const PeerPoint point = make_openmm_peer(fluid, {})->point();
    for (std::size_t i = 0; i < fluid.masses.size(); ++i) {
        unshifted.velocities[i] += argon_step / (2.0 * fluid.masses[i]) * point.forces[i];
    }
    const auto peer = make_openmm_peer(unshifted, {});
    const auto comparison = compare_trajectories(fluid, by(cut()), *peer, argon_step, {1});
    CHECK(comparison.rows[0].distances[0] == Approx(7.5e-4).epsilon(0.3));
    CHECK(any_failed(checks_of(comparison, {1}, doubles(fluid))));
}

TEST_CASE("a cutoff that is longer by 1e-4 does not pass") {
    const Fluid fluid = triple_point(6, cut());
    Fluid longer = fluid;
    longer.potential = PairPotential::lennard_jones("cut", {2.5001, 2.0});
    const auto peer = make_openmm_peer(longer, {});
    CHECK(any_failed(point_checks(fluid, *peer, doubles(fluid), by(cut()))));
    CHECK(any_failed(trajectory_checks(fluid, *peer, doubles(fluid), by(cut()), {100})));
}

TEST_CASE("an epsilon that is larger by 1e-9 does not pass") {
    const Fluid fluid = triple_point(6, cut());
    const auto peer = make_openmm_peer(fluid, {.epsilon = 1.0 + 1e-9});
    for (const Check& check : point_checks(fluid, *peer, doubles(fluid), by(cut()))) {
        INFO(check.name << ": " << check.value);
        CHECK_FALSE(check.passed());
    }
    CHECK(any_failed(trajectory_checks(fluid, *peer, doubles(fluid), by(cut()), {100})));
}

TEST_CASE("a time step that is longer by 1e-9 does not pass") {
    const Fluid fluid = triple_point(6, cut());
    const auto peer = make_openmm_peer(fluid, {});
    const auto theirs = peer->follow("VerletIntegrator", argon_step * (1.0 + 1e-9), {10});
    const auto ours = follow(fluid, *by(cut())(), "leapfrog", argon_step, {10});
    double largest = 0.0;
    for (std::size_t i = 0; i < fluid.masses.size(); ++i) {
        largest = std::max(largest, (ours[0].positions[i] - theirs[0].positions[i]).norm());
    }
    CHECK(largest > limit_at(doubles(fluid).positions, 10).value());
}
