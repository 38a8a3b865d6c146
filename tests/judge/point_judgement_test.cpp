#include "judge/point_judgement.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

ExpectedPoint made_point() {
    return {.sums = {-10.0, 6.0, {Vec3(1, 0, 0), Vec3(-1, 0, 0)}},
            .kinetic_energy = 3.0,
            .tail_energy = -0.5,
            .tail_pressure = -0.25,
            .volume = 8.0,
            .atoms = 2};
}

}  // namespace

TEST_CASE("temperature and pressure of a point follow from its sums") {
    const ExpectedPoint point = made_point();
    CHECK(point.potential_energy() == -10.5);
    CHECK(point.temperature() == 2.0);
    CHECK(point.pressure() == 12.0 / 24.0 - 0.25);
}

TEST_CASE("each part of an answer is checked against its own size") {
    const PointAnswer answer{.potential_energy = -10.4,
                             .kinetic_energy = 3.3,
                             .temperature = 2.0,
                             .virial = 7.2,
                             .pressure = 0.25,
                             .forces = {Vec3(1, 0.5, 0), Vec3(-1, 0, 0)}};
    const auto checks = check_point(made_point(), answer, engine_agreement({}));
    const auto value = [&](const std::string& name) {
        for (const Check& check : checks) {
            if (check.name == name) {
                return check.value;
            }
        }
        return -1.0;
    };
    CHECK(value("potential energy") == Approx(0.01));
    CHECK(value("kinetic energy") == Approx(0.1));
    CHECK(value("temperature") == 0.0);
    CHECK(value("virial") == Approx(0.1));
    CHECK(value("pressure") == 0.0);
    CHECK(value("largest force difference") == Approx(0.5));
    CHECK(value("rms force difference") == Approx(std::sqrt(0.125)));
}

TEST_CASE("an engine is allowed ten times what LAMMPS is") {
    const Agreement lammps = lammps_agreement({});
    const Agreement engine = engine_agreement({});
    CHECK(engine.energy == Approx(10.0 * lammps.energy));
    CHECK(engine.positions.front().distance == Approx(10.0 * lammps.positions.front().distance));
}
