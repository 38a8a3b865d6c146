#include "ljmd/engine/snapshot.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "engine/fluid_system.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("a snapshot gives atoms by their ids, whatever their order in memory") {
    const FluidSpec spec = small_spec();
    FluidSystem fluid = make_fluid(spec, Execution(), [](const std::string&) {});
    State& state = fluid.state;
    std::vector<Index> order;
    for (Index i = 0; i < state.count(); ++i) {
        order.push_back((i * 5 + 3) % state.count());  // 5 and 108 have no common factor
    }
    const Evaluation evaluation = fluid.force_field.evaluate(state, Request::forces_and_energy);
    state.reorder(order);
    state.set_image(0, Eigen::Vector3i(1, 0, -2));
    const Snapshot snapshot(state, fluid.tail, evaluation);
    CHECK(snapshot.atoms() == 108);
    CHECK(snapshot.edges() == state.box().edges());
    for (Index i = 0; i < state.count(); ++i) {
        const Index id = state.ids()[static_cast<std::size_t>(i)];
        CHECK(snapshot.positions().col(id) == state.positions().col(i));
        CHECK(snapshot.unwrapped().col(id) == state.unwrapped(i));
        CHECK(snapshot.velocities().col(id) == state.velocities().col(i));
        CHECK(snapshot.forces().col(id) == state.forces().col(i));
    }
    CHECK(snapshot.thermodynamics().potential_energy == evaluation.potential_energy / 108.0);
    CHECK(snapshot.thermodynamics().temperature.value() == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("positions are in the box, also those of atoms that have left it since the last list was built") {
    State state(2, Box(Vec3::Constant(4.0)));
    state.write_positions().col(0) = Vec3(-0.25, 4.5, 1.0);
    const Snapshot snapshot(state, TailCorrection(), std::nullopt);
    CHECK(snapshot.positions().col(0) == Vec3(3.75, 0.5, 1.0));
    CHECK(snapshot.unwrapped().col(0) == Vec3(-0.25, 4.5, 1.0));
    CHECK_THROWS_AS(snapshot.thermodynamics(), InputError);
}
