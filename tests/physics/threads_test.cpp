// The number of threads changes no bit of a run: lists, ghosts, forces, sums, motion and what is measured alike.
#include <algorithm>
#include "catch.hpp"

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "observables/structure/order_parameter.hpp"
#include "observables/structure/radial_distribution.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

constexpr Index unit_cells = 9;  // 2916 atoms: two whole blocks of the usual length and part of a third

struct Run {
    Eigen::Matrix3Xd positions;
    Eigen::Matrix3Xd velocities;
    Evaluation last;
    Thermodynamics thermodynamics;
    double order;
    DataTable rdf;
};

Run run_with(int threads, Precision precision, const std::string& search, const std::string& integrator) {
    const Execution execution({.threads = threads, .precision = precision});
    State state = test::crystal(unit_cells, 0.8442, execution);
    draw_velocities(state, 1.44, 3);
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    PairForceField force_field(potential, make_pair_search(search, 0.3), execution);
    test::advance(state, force_field, 0.005, 20, integrator);
    rescale_velocities(state, 0.75);
    const Evaluation last = force_field.evaluate(state, Request::forces_and_energy);
    RadialDistribution rdf(50, 2.5, Every(1));
    rdf.sample(state, {});
    return {test::unwrapped_by_id(state),
            test::by_id(state, state.velocities()),
            last,
            thermodynamics(state, last, TailCorrection(potential)),
            TranslationalOrder(Lattice::fcc, unit_cells, unit_cells)(state),
            rdf.tables().at(0)};
}

/// Columns r, g and coordination number: one sample has no standard error.
bool same_numbers(const DataTable& a, const DataTable& b) {
    return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
                      [](const auto& x, const auto& y) { return x[0] == y[0] && x[1] == y[1] && x[3] == y[3]; });
}

void check_same_bits(Precision precision, const std::string& search, const std::string& integrator) {
    CAPTURE(name(precision), search, integrator);
    const Run one = run_with(1, precision, search, integrator);
    for (const int threads : {2, 3, 8}) {
        CAPTURE(threads);
        const Run several = run_with(threads, precision, search, integrator);
        CHECK(several.positions == one.positions);
        CHECK(several.velocities == one.velocities);
        CHECK(several.last.potential_energy == one.last.potential_energy);
        CHECK(several.last.virial == one.last.virial);
        CHECK(several.thermodynamics.temperature == one.thermodynamics.temperature);
        CHECK(several.thermodynamics.kinetic_energy == one.thermodynamics.kinetic_energy);
        CHECK(several.thermodynamics.pressure_tensor == one.thermodynamics.pressure_tensor);
        CHECK(several.order == one.order);
        CHECK(same_numbers(several.rdf, one.rdf));
    }
}

}  // namespace

TEST_CASE("20 steps of a melting crystal of 2916 atoms are the same bits on 1, 2, 3 and 8 threads") {
    check_same_bits(Precision::double_precision, "verlet-list", "velocity-verlet");
    check_same_bits(Precision::mixed, "verlet-list", "velocity-verlet");
    check_same_bits(Precision::double_precision, "cells", "leapfrog");
    check_same_bits(Precision::double_precision, "verlet-list", "bit-reversible");
    check_same_bits(Precision::mixed, "verlet-list", "position-verlet");
    check_same_bits(Precision::mixed, "verlet-list", "rk2-midpoint");
}
