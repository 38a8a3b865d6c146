#include "ljmd/forces/external_force.hpp"

#include <limits>
#include "catch.hpp"

#include "forces/evaluated.hpp"
#include "forces/made_external_force.hpp"
#include "forces/pair_force_field.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

PairForceField with(const std::shared_ptr<ExternalForce>& external, const std::string& search = "verlet-list") {
    PairForceField field(PairPotential::lennard_jones("force-shifted", {.radius = 2.0, .switch_start = 0.0}),
                         make_pair_search(search, 0.3));
    field.set_external(external);
    return field;
}

std::shared_ptr<MadeForce> constant(const Eigen::Matrix3Xd& by_id, ExternalEnergy energy = {}) {
    return std::make_shared<MadeForce>([=](const AtomPositions&, Eigen::Matrix3Xd& forces) {
        forces = by_id;
        return energy;
    });
}

}  // namespace

TEST_CASE("an external force is added to the pair forces by id, whatever the order in memory") {
    const State start = fluid();
    Eigen::Matrix3Xd each(3, start.count());
    for (Index id = 0; id < start.count(); ++id) {
        each.col(id) << static_cast<double>(id), -2.0, 0.5 * static_cast<double>(id * id);
    }
    for (const std::string& search : pair_search_names()) {
        CAPTURE(search);
        State without = start;
        State state = start;
        const Evaluation pairs = with(nullptr, search).evaluate(without, Request::forces_and_energy);
        const Evaluation all = with(constant(each, {7.0}), search).evaluate(state, Request::forces_and_energy);
        CHECK(by_id(state, state.forces()) == by_id(without, without.forces()) + each);
        CHECK(all.potential_energy == pairs.potential_energy);
        CHECK(all.virial == pairs.virial);
        CHECK(all.external_energy == 7.0);
        CHECK_FALSE(pairs.external_energy.has_value());
        if (search == "verlet-list") {
            CHECK(state.ids() != start.ids());  // else this tests nothing
        }
    }
}

TEST_CASE(
    "an external force is called once an evaluation, and sees positions by id, wrapped and unwrapped, and the time") {
    State state = fluid();
    state.time = 1.25;
    state.set_image(3, {2, 0, -1});
    Eigen::Matrix3Xd positions;
    Eigen::Matrix3Xd unwrapped;
    const auto force = std::make_shared<MadeForce>([&](const AtomPositions& atoms, Eigen::Matrix3Xd& forces) {
        CHECK(forces == Eigen::Matrix3Xd::Zero(3, atoms.atoms()));
        CHECK(atoms.time() == 1.25);
        CHECK(atoms.edges() == state.box().edges());
        positions = atoms.positions();
        unwrapped = atoms.unwrapped();
        return ExternalEnergy{};
    });
    PairForceField field = with(force);
    for (int call = 1; call <= 3; ++call) {
        field.evaluate(state, call == 2 ? Request::forces_and_energy : Request::forces);
        CHECK(force->calls == call);
        CHECK(force->energies == (call < 2 ? 0 : 1));
        for (Index i = 0; i < state.count(); ++i) {
            const Index id = state.ids()[static_cast<std::size_t>(i)];
            CHECK(unwrapped.col(id) == state.unwrapped(i));
            const Vec3 edges_between = (unwrapped.col(id) - positions.col(id)).cwiseQuotient(state.box().edges());
            CHECK((edges_between - edges_between.array().round().matrix()).norm() < 1e-12);
            CHECK((positions.col(id).array() >= 0.0).all());
            CHECK((positions.col(id).array() < state.box().edges().array()).all());
        }
        state.write_positions().col(5) += Vec3(state.box().edges());
    }
}

TEST_CASE("the virial of an external force is the response of its energy to a change of the box") {
    constexpr double h = 1e-6;
    const State start = fluid();
    const auto found = [&](const std::shared_ptr<ExternalForce>& force, double stretch) {
        State state = start;
        state.rescale_to(Box(stretch * state.box().edges()));
        return with(force).evaluate(state, Request::forces_and_energy);
    };
    const auto alone = [&](double stretch) { return found(nullptr, stretch); };
    for (const std::shared_ptr<ExternalForce>& force :
         {std::shared_ptr<ExternalForce>(trap(0.7)), std::shared_ptr<ExternalForce>(wave(2.0))}) {
        const double response =
            -(*found(force, 1.0 + h).external_energy - *found(force, 1.0 - h).external_energy) / (2.0 * h);
        const double virial = found(force, 1.0).virial.trace() - alone(1.0).virial.trace();
        CHECK(std::abs(virial - response) < 1e-5 * (1.0 + std::abs(response)));
    }
    CHECK(found(trap(0.7), 1.0).virial.trace() < alone(1.0).virial.trace() - 1.0);
}

TEST_CASE("what is not finite names the atom, and a wrong shape is refused") {
    const State start = fluid();
    const auto evaluate = [&](const std::shared_ptr<ExternalForce>& force, Request request) {
        State state = start;
        static_cast<void>(with(force).evaluate(state, request));
    };
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, start.count());
    forces(1, 41) = not_a_number;
    CHECK_THROWS_AS(evaluate(constant(forces), Request::forces), PhysicsError);
    CHECK_THROWS_WITH(evaluate(constant(forces), Request::forces),
                      Contains("external force 'made' on atom 42 is (0, nan, 0), not finite"));
    forces(1, 41) = 0.0;
    CHECK_NOTHROW(evaluate(constant(forces, {not_a_number}), Request::forces));
    CHECK_THROWS_WITH(evaluate(constant(forces, {not_a_number}), Request::forces_and_energy),
                      Contains("energy of the external"));
    const auto bad_virial = std::make_shared<MadeForce>(
        [](const AtomPositions&, Eigen::Matrix3Xd&) {
            return ExternalEnergy{0.0, Mat3::Constant(not_a_number)};
        },
        false, true);
    CHECK_THROWS_WITH(evaluate(bad_virial, Request::forces_and_energy), Contains("virial of the external force"));
    CHECK_THROWS_AS(evaluate(constant(Eigen::Matrix3Xd::Zero(3, 5)), Request::forces), InputError);
}
