#pragma once

#include <string>

#include "execution/test_execution.hpp"
#include "forces/pair_force_field.hpp"
#include "integrators/integrator.hpp"
#include "ljmd/model/lattice.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/linear_trend.hpp"

namespace ljmd::test {

/// Lennard-Jones with rc = 2.5 (2.0 for the start of the switch) and a pair search by name.
inline PairForceField lennard_jones(const std::string& truncation, const std::string& search = "verlet-list",
                                    double skin = 0.3) {
    return {PairPotential::lennard_jones(truncation, {2.5, 2.0}), make_pair_search(search, skin)};
}

inline void place(State& state, const std::vector<Vec3>& positions) {
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = positions[static_cast<std::size_t>(i)];
    }
}

/// An fcc crystal at rest.
inline State crystal(Index cells, double density, const Execution& execution = test_execution()) {
    const Index atoms = lattice_atoms(Lattice::fcc, cells);
    const Box box = cubic_box(atoms, density);
    State state(atoms, box, execution);
    place(state, lattice_sites(Lattice::fcc, cells, box));
    return state;
}

/// n steps of an integrator, by its name.
inline void advance(State& state, ForceField& force_field, double dt, Index steps,
                    const std::string& name = "velocity-verlet") {
    const Integrator integrator(find_integrator(name), dt);
    for (Index n = 0; n < steps; ++n) {
        integrator.step(state, force_field, Request::forces);
    }
}

/// A liquid near Verlet's triple-point state (0.8442, 0.75): a crystal melted at T = 2 and cooled by rescaling. The
/// kernels of one level do it, so that it is the same liquid on all processors of a kind: two that differ by rounding
/// at first are others in the end, and in some a pair comes so close to the cutoff that compared trajectories part
/// there.
inline State liquid(Index cells, std::uint64_t seed, const std::string& truncation = "force-shifted") {
    State state = crystal(cells, 0.8442);
    PairForceField force_field(PairPotential::lennard_jones(truncation, {2.5, 2.0}),
                               make_pair_search("verlet-list", 0.3), Execution({.simd = SimdLevel::portable}));
    draw_velocities(state, 2.0, seed);
    for (int block = 0; block < 60; ++block) {
        advance(state, force_field, 0.005, 20);
        rescale_velocities(state, block < 30 ? 2.0 : 0.75);
    }
    remove_momentum(state);
    return state;
}

/// Total energy from a fresh evaluation (the state is copied: atoms may be rearranged by it).
inline double total_energy(State state, PairForceField force_field) {
    return force_field.evaluate(state, Request::forces_and_energy).potential_energy + kinetic_energy(state);
}

/// Drift of the total energy per atom [epsilon/tau] over some steps of velocity Verlet, from every tenth of them.
/// @pre at least 20 steps
inline double energy_drift(State& state, ForceField& force_field, double dt, Index steps) {
    const Integrator integrator(find_integrator("velocity-verlet"), dt);
    LinearTrend energy;
    for (Index n = 1; n <= steps; ++n) {
        const bool sample = n % 10 == 0;
        const auto evaluation =
            integrator.step(state, force_field, sample ? Request::forces_and_energy : Request::forces);
        if (sample) {
            const double total = evaluation.potential_energy + kinetic_energy(state);
            energy.add(dt * static_cast<double>(n), total / static_cast<double>(state.count()));
        }
    }
    return energy.slope().value();
}

/// Column id of the result belongs to atom id.
inline Eigen::Matrix3Xd by_id(const State& state, const ConstVectorView& values) {
    Eigen::Matrix3Xd result(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        result.col(state.ids()[static_cast<std::size_t>(i)]) = values.col(i);
    }
    return result;
}

inline Eigen::Matrix3Xd unwrapped_by_id(const State& state) {
    Eigen::Matrix3Xd result(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        result.col(state.ids()[static_cast<std::size_t>(i)]) = state.unwrapped(i);
    }
    return result;
}

/// Largest |a_i - b_i| over the root mean square of |b_i|.
inline double largest_difference_over_rms(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    const double rms = b.norm() / std::sqrt(static_cast<double>(b.cols()));
    return (a - b).colwise().norm().maxCoeff() / rms;
}

}  // namespace ljmd::test
