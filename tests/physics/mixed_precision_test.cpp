// What mixed precision conserves and how near it stays to double. Its gates are wider than those of double by what a
// single-precision pair term is worth.
#include <cmath>
#include "catch.hpp"

#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

PairForceField lennard_jones(const std::string& truncation, Precision precision) {
    return {PairPotential::lennard_jones(truncation, {2.5, 2.0}), make_pair_search("verlet-list", 0.3),
            Execution({.precision = precision})};
}

double energy_per_atom(const State& state, const PairForceField& force_field) {
    return test::total_energy(state, force_field) / static_cast<double>(state.count());
}

}  // namespace

TEST_CASE("in mixed precision the energy of 256 atoms drifts less than 1e-6 over 1e5 steps, and momentum stays small",
          "[slow]") {
    State state = test::liquid(4, 7);
    auto force_field = lennard_jones("force-shifted", Precision::mixed);
    const double drift = test::energy_drift(state, force_field, 0.004, 100000);
    CAPTURE(drift, total_momentum(state).norm());
    CHECK(std::abs(drift) < 1e-6);
    CHECK(total_momentum(state).norm() < 1e-2);
    CHECK(*temperature(state) > 0.5);
}

TEST_CASE("after 100 steps from a common start mixed precision has the energies of double within 1e-6") {
    State exact = test::crystal(6, 0.8442);
    draw_velocities(exact, 1.44, 87287);
    State mixed = exact;
    auto in_double = lennard_jones("cut", Precision::double_precision);
    auto in_mixed = lennard_jones("cut", Precision::mixed);
    test::advance(exact, in_double, 0.005, 100);
    test::advance(mixed, in_mixed, 0.005, 100);
    CHECK(energy_per_atom(mixed, in_mixed) == Approx(energy_per_atom(exact, in_double)).epsilon(1e-6));
    CHECK(kinetic_energy(mixed) == Approx(kinetic_energy(exact)).epsilon(1e-6));
    CHECK(mixed.positions() != exact.positions());  // it is not double by another name
}
