#include "ljmd/observables/structure/order_parameter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "neighbors/sample_states.hpp"

using namespace ljmd;

TEST_CASE("the order parameter is 1 on the lattice it is made for") {
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const Index cells = GENERATE(Index{1}, Index{3}, Index{6});
    const State state = test::crystal_state(lattice, cells, cubic_box(lattice_atoms(lattice, cells), 0.8442));
    CHECK(TranslationalOrder(lattice, cells, cells)(state) == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a shift of the crystal along x by half the distance of its planes gives (-1 + 1 + 1) / 3") {
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const double constant = 1.5;
    const double half = constant * (lattice == Lattice::fcc ? 0.25 : 0.5);
    State state = test::crystal_state(lattice, 4, Box(Vec3::Constant(4.0 * constant)));
    for (Index i = 0; i < state.count(); ++i) {
        state.write_positions()(0, i) += half;
    }
    CHECK(TranslationalOrder(lattice, 4, 4)(state) == Approx(1.0 / 3.0).epsilon(1e-12));
}

TEST_CASE("the order parameter is the mean of the cosines that define it") {
    const Vec3 edges(4.0, 5.0, 7.0);
    const State state = test::random_state(1000, Box(edges), 5);
    double sum = 0.0;
    for (Index i = 0; i < state.count(); ++i) {
        sum += (2.0 * std::numbers::pi * 6.0 * state.positions().col(i).cwiseQuotient(edges)).array().cos().sum();
    }
    CHECK(TranslationalOrder(Lattice::fcc, 3, 3)(state) == Approx(sum / 3000.0).epsilon(1e-12).margin(1e-13));
    State one = test::random_state(1, Box(edges), 1);
    for (int k = -70; k <= 70; ++k) {
        one.write_positions().col(0) = 0.05 * k * edges / 6.0;
        CHECK(TranslationalOrder(Lattice::fcc, 3, 3)(one) ==
              Approx(std::cos(0.1 * std::numbers::pi * k)).margin(2e-13));
    }
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
