// A program of somebody else that uses an installed ljmd: the energy of a Lennard-Jones crystal.
#include <cmath>
#include <iostream>

#include "ljmd/core/build_info.hpp"
#include "ljmd/forces/pair_force_field.hpp"
#include "ljmd/model/lattice.hpp"

int main() {
    const ljmd::Index atoms = ljmd::lattice_atoms(ljmd::Lattice::fcc, 5);
    ljmd::State state(atoms, ljmd::cubic_box(atoms, 1.0));
    const auto sites = ljmd::lattice_sites(ljmd::Lattice::fcc, 5, state.box());
    auto positions = state.write_positions();
    for (ljmd::Index i = 0; i < atoms; ++i) {
        positions.col(i) = sites[static_cast<std::size_t>(i)];
    }

    ljmd::PairForceField force_field(ljmd::PairPotential::lennard_jones("cut", {.radius = 2.5}),
                                     ljmd::make_pair_search("verlet-list", 0.3));
    const auto evaluation = force_field.evaluate(state, ljmd::Request::forces_and_energy);
    const double energy = evaluation.potential_energy / static_cast<double>(atoms);
    const double largest_force = state.forces().cwiseAbs().maxCoeff();
    std::cout << "ljmd " << ljmd::build_info().version << ": " << energy << " epsilon an atom, largest force "
              << largest_force << '\n';
    // Shell n of fcc lies at r^2 = n a^2/2, a = 4^(1/3); those within the cutoff hold 12, 6, 24 and 12 atoms:
    // u = sum over n of 2 m_n (r^-12 - r^-6) = -7.76159.
    return std::abs(energy + 7.76159) < 1e-5 && largest_force < 1e-10 ? 0 : 1;
}
