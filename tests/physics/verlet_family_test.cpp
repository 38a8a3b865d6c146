// The integrators of the Verlet family move a Lennard-Jones liquid along the same trajectory, and one of them back
// along it to the last bit.
#include <string>
#include "catch.hpp"

#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

/// Largest distance of an atom from where velocity Verlet has moved it.
double distance_from_velocity_verlet(const std::string& integrator, Index steps) {
    State verlet = test::liquid(4, 3);
    State other = verlet;
    auto forces = test::lennard_jones("force-shifted");
    auto other_forces = forces;
    test::advance(verlet, forces, 0.004, steps);
    test::advance(other, other_forces, 0.004, steps, integrator);
    return (test::unwrapped_by_id(verlet) - test::unwrapped_by_id(other)).colwise().norm().maxCoeff();
}

// Every step is another chance to lose a bit, to a pair at the cutoff, a list rebuilt at another time, or a sum in
// another order. The atoms are wrapped, sorted and their list is rebuilt thousands of times on the way.
/// @param cells  of the lattice along each edge
void check_way_back(Index cells, Index steps) {
    State state = test::liquid(cells, 17, "cut");
    auto force_field = test::lennard_jones("cut");
    const Integrator integrator(find_integrator("bit-reversible"), 0.004);
    integrator.step(state, force_field, Request::forces);
    const Eigen::Matrix3Xd r = test::unwrapped_by_id(state);
    const Eigen::Matrix3Xd v = test::by_id(state, static_cast<const State&>(state).velocities());
    const auto go = [&] {
        for (Index n = 0; n < steps; ++n) {
            integrator.step(state, force_field, Request::forces);
        }
    };
    go();
    CHECK((test::unwrapped_by_id(state) - r).colwise().norm().mean() > 0.5);
    CHECK(force_field.search_statistics().rebuilds > steps / 100);
    integrator.reverse(state, force_field);
    go();
    CHECK(test::unwrapped_by_id(state) == r);
    CHECK(test::by_id(state, static_cast<const State&>(state).velocities()) == -v);
}

}  // namespace

TEST_CASE("leapfrog and position Verlet from mapped starts follow velocity Verlet through a liquid") {
    for (const std::string integrator : {"leapfrog", "position-verlet", "bit-reversible"}) {
        CAPTURE(integrator);
        CHECK(distance_from_velocity_verlet(integrator, 100) < 1e-11);
        CHECK(distance_from_velocity_verlet(integrator, 500) < 1e-8);
    }
    CHECK(distance_from_velocity_verlet("drift-kick-drift", 100) > 1e-6);  // another trajectory of the same order
}

TEST_CASE("forces summed independently of order are the same bits wherever the atoms lie in memory") {
    const State start = test::liquid(4, 5);
    Eigen::Matrix3Xd before;
    Eigen::Matrix3Xd floating;
    for (const std::string search : {"verlet-list", "cells", "all-pairs"}) {
        State state = start;
        if (search == "all-pairs") {
            std::vector<Index> order(static_cast<std::size_t>(state.count()));
            for (std::size_t k = 0; k < order.size(); ++k) {
                order[k] = static_cast<Index>((7 * k + 3) % order.size());
            }
            state.reorder(order);
        }
        auto force_field = test::lennard_jones("cut", search);
        force_field.evaluate(state, Request::forces);
        const Eigen::Matrix3Xd rounded = test::by_id(state, static_cast<const State&>(state).forces());
        force_field.evaluate(state, {.energy = true, .order_independent = true});
        const Eigen::Matrix3Xd exact = test::by_id(state, static_cast<const State&>(state).forces());
        CHECK(test::largest_difference_over_rms(exact, rounded) < 1e-13);
        CHECK(exact.rowwise().sum().norm() < 1e-10);
        if (before.cols() > 0) {
            CHECK(exact == before);
            CHECK(rounded != floating);
        }
        before = exact;
        floating = rounded;
    }
}

TEST_CASE("bit-reversible: 864 atoms return to their start bit for bit after 2e3 steps forward and 2e3 back",
          "[slow]") {
    check_way_back(6, 2'000);
}

TEST_CASE("bit-reversible: 256 atoms return to their start bit for bit after 1e5 steps forward and 1e5 back",
          "[long]") {
    check_way_back(4, 100'000);
}
