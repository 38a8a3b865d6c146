#include "engine/fluid_system.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// Two atoms, the second one outside the box.
Configuration pair_of_atoms() {
    return {.edges = Vec3::Constant(5.0),
            .positions = {Vec3::Zero(), Vec3(-4.0, 1.0, 11.0)},
            .velocities = {Vec3(0.0, 0.0, 0.5), Vec3(0.0, 0.0, 1.5)}};
}

struct Warnings {
    FluidSystem make(const FluidSpec& spec) {
        return make_fluid(spec, Execution(), [this](const std::string& text) { all.push_back(text); });
    }
    std::vector<std::string> all;
};

}  // namespace

TEST_CASE("a configuration is placed with its images, and its centre of mass is brought to rest") {
    FluidSpec spec = small_spec();
    spec.start = pair_of_atoms();
    Warnings warnings;
    const FluidSystem fluid = warnings.make(spec);
    CHECK(fluid.state.unwrapped(1) == Vec3(-4.0, 1.0, 11.0));
    CHECK(fluid.state.image(1) == Eigen::Vector3i(-1, 0, 2));
    CHECK(fluid.state.positions().col(1) == Vec3(1.0, 1.0, 1.0));
    CHECK(total_momentum(fluid.state).norm() == 0.0);
    REQUIRE(warnings.all.size() == 1);
    CHECK_THAT(warnings.all[0], Contains("moved with 1 sigma/tau"));
    CHECK_FALSE(fluid.order);
}

TEST_CASE("velocities are drawn for a lattice, for random places, and where those of a file are not kept") {
    FluidSpec spec = small_spec();
    Warnings warnings;
    const FluidSystem crystal = warnings.make(spec);
    CHECK(temperature(crystal.state).value() == Approx(1.0).epsilon(1e-13));
    CHECK((*crystal.order)(crystal.state) == Approx(1.0).epsilon(1e-12));
    spec.start = RandomStart{108};
    const FluidSystem random = warnings.make(spec);
    CHECK(random.relaxation_iterations > 0);
    CHECK_FALSE(random.order);
    spec.start = pair_of_atoms();
    spec.keep_velocities = false;
    CHECK(temperature(warnings.make(spec).state).value() == Approx(1.0).epsilon(1e-13));
    CHECK(warnings.all.empty());
}

TEST_CASE("an atom far away, or of another mass, is refused") {
    FluidSpec spec = small_spec();
    Configuration far = pair_of_atoms();
    far.positions[1][0] = 1e7;
    spec.start = far;
    Warnings warnings;
    CHECK_THROWS_AS(warnings.make(spec), DataError);
    Configuration heavy = pair_of_atoms();
    heavy.masses = {1.0, 2.0};
    spec.start = heavy;
    CHECK_THROWS_WITH(warnings.make(spec), Contains("mass 2"));
}

TEST_CASE("tail and analyses are there when the specification asks for them") {
    FluidSpec spec = small_spec();
    CHECK(empty_fluid(spec, 108, box_of(spec), Execution()).tail.energy(0.8) == 0.0);
    spec.potential = PairPotential::lennard_jones("cut", {.radius = 2.0, .switch_start = 0.0});
    spec.tail = true;
    spec.analyses = {analysis("rdf")};
    const FluidSystem fluid = empty_fluid(spec, 108, box_of(spec), Execution());
    CHECK(fluid.tail.energy(0.8) < 0.0);
    CHECK(fluid.analyses.size() == 1);
}
