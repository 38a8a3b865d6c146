#include "observables/structure/order_parameter.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"

using namespace ljmd;

TEST_CASE("the order parameter is 1 on the lattice it is made for") {
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const Index cells = GENERATE(Index{1}, Index{3}, Index{6});
    const State state = test::crystal_state(lattice, cells, cubic_box(lattice_atoms(lattice, cells), 0.8442));
    CHECK(TranslationalOrder(lattice, cells, cells)(state) == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("atoms that leave their planes along x by half the distance of these give (-1 + 1 + 1) / 3") {
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const double constant = 1.5;
    const double half = constant * (lattice == Lattice::fcc ? 0.25 : 0.5);
    State state = test::crystal_state(lattice, 4, Box(Vec3::Constant(4.0 * constant)));
    for (Index i = 0; i < state.count(); ++i) {
        state.write_positions()(0, i) += i % 2 == 0 ? half : -half;
    }
    CHECK(TranslationalOrder(lattice, 4, 4)(state) == Approx(1.0 / 3.0).epsilon(1e-12));
}

TEST_CASE("a crystal that drifts as a whole keeps its order, wherever it is, and however often it has left the box") {
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const Box box = Box(Vec3(6.0, 6.0, 9.0));
    const TranslationalOrder order(lattice, 4, 6);
    for (const Vec3& drift : {Vec3(0.375, 0.0, 0.0), Vec3(0.75, -0.375, 0.375), Vec3(-40.3, 5.9, 777.7)}) {
        State state = test::state_of(lattice_sites(lattice, 4, 6, box.edges(), box), box);
        state.write_positions().colwise() += drift;
        for (Index i = 0; i < state.count(); ++i) {
            state.write_positions().col(i) = state.snapped(state.positions().col(i));
        }
        CHECK(order(state) == Approx(1.0).epsilon(1e-11));
        state.wrap();
        CHECK(order(state) == Approx(1.0).epsilon(1e-11));
    }
}

TEST_CASE("the order parameter is the mean of the cosines that define it") {
    const Vec3 edges(4.0, 5.0, 7.0);
    const State state = test::random_state(1000, Box(edges), 5);
    const Vec3 of_lattice = 2.5 / 6.0 * edges;  // six planes from 0 on
    const Vec3 drift = state.positions().rowwise().mean() - of_lattice;
    double sum = 0.0;
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 r = state.positions().col(i) - drift;
        sum += (2.0 * std::numbers::pi * 6.0 * r.cwiseQuotient(edges)).array().cos().sum();
    }
    CHECK(TranslationalOrder(Lattice::fcc, 3, 3)(state) == Approx(sum / 3000.0).epsilon(1e-11).margin(1e-12));
}

TEST_CASE("wrapping, and scaling of the box, do not change the order parameter") {
    State state = test::shaken_crystal(4, 0.8442, 0.1, 3);  // atoms stand out of the box
    const TranslationalOrder order(Lattice::fcc, 4, 4);
    const double before = order(state);
    CHECK(before > 0.5);
    CHECK(before < 0.95);
    const Vec3 first = static_cast<const State&>(state).positions().col(0);
    state.wrap();
    REQUIRE(static_cast<const State&>(state).positions().col(0) != first);
    CHECK(order(state) == Approx(before).epsilon(1e-12));
    state.rescale_to(Box(1.1 * state.box().edges()));
    CHECK(order(state) == Approx(before).epsilon(1e-12));
}

TEST_CASE("in a box that is no cube each edge has its own planes") {
    const Box box(Vec3(4.0, 5.0, 7.0));
    const Vec3 edges = crystal_edges(Lattice::fcc, 2, 5, 0.8);
    CHECK(TranslationalOrder(Lattice::fcc, 2, 5)(test::state_of(lattice_sites(Lattice::fcc, 2, 5, edges, Box(edges)),
                                                                Box(edges))) == Approx(1.0).epsilon(1e-12));
    CHECK(TranslationalOrder(Lattice::fcc, 2, 2)(test::crystal_state(Lattice::fcc, 2, box)) ==
          Approx(1.0).epsilon(1e-12));
}

TEST_CASE("the order parameter of random positions scatters about 0 by (6 N)^(-1/2)") {
    const Index atoms = 500;
    const TranslationalOrder order(Lattice::fcc, 5, 5);
    double sum = 0.0;
    double squares = 0.0;
    const int samples = 400;
    for (int k = 0; k < samples; ++k) {
        const double lambda = order(test::random_state(atoms, cubic_box(atoms, 0.8442), static_cast<unsigned>(k)));
        sum += lambda;
        squares += lambda * lambda;
    }
    const double width = 1.0 / std::sqrt(6.0 * static_cast<double>(atoms));
    CHECK(std::abs(sum / samples) < 3.0 * width / std::sqrt(samples));
    CHECK(std::sqrt(squares / samples) == Approx(width).epsilon(0.12));  // 3 standard errors: 3 / (2 * 400)^(1/2)
}
