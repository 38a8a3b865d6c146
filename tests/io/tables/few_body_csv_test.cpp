#include "io/tables/few_body_csv.hpp"

#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

std::string thermo_of(int dimensions) {
    const test::TemporaryFolder folder;
    FewBodyThermoCsv csv(folder / "thermo.csv", dimensions);
    csv.write(7, 0.1, {-1.0 / 3.0, 2.0, 5.0 / 3.0, Vec3(1.5, 2.5, 3.5), Vec3(-4.0, 1e-30, 6.0)});
    csv.close();
    return test::content_of(folder / "thermo.csv");
}

/// Two bodies of which the second lies first in memory, with forces.
State swapped_bodies() {
    State state(2);
    state.reorder({1, 0});
    state.step = 3;
    state.time = 0.3;
    const auto index = state.index_of();
    for (const Index id : {0, 1}) {
        const Index i = index[static_cast<std::size_t>(id)];
        const double k = static_cast<double>(id);
        state.write_positions().col(i) = Vec3(1.0, 2.0, 3.0) + Vec3::Constant(10.0 * k);
        state.write_velocities().col(i) = Vec3(0.1, 0.2, 0.3) + Vec3::Constant(k);
        state.write_forces().col(i) = Vec3(4.0, 6.0, 8.0) + Vec3::Constant(10.0 * k);
        state.write_masses()[static_cast<std::size_t>(i)] = 2.0 + 2.0 * k;
    }
    return state;
}

std::string trajectory_of(int dimensions, bool accelerations, std::optional<double> angle) {
    const test::TemporaryFolder folder;
    TrajectoryCsv csv(folder / "trajectory.csv", {2, dimensions, accelerations, angle.has_value()});
    csv.write(swapped_bodies(), angle);
    csv.close();
    return test::content_of(folder / "trajectory.csv");
}

}  // namespace

TEST_CASE("the history of few bodies has momenta in as many dimensions as they move in, all digits") {
    const std::string energies = "step,time,potential_energy,kinetic_energy,total_energy";
    const std::string values = "\n7,0.1,-0.3333333333333333,2,1.6666666666666667";
    CHECK(thermo_of(1) == energies + ",momentum_x" + values + ",1.5\n");
    CHECK(thermo_of(2) == energies + ",momentum_x,momentum_y,angular_momentum_z" + values + ",1.5,2.5,6\n");
    CHECK(thermo_of(3) == energies +
                              ",momentum_x,momentum_y,momentum_z,angular_momentum_x,angular_momentum_y,"
                              "angular_momentum_z" +
                              values + ",1.5,2.5,3.5,-4,1e-30,6\n");
}

TEST_CASE("the path of few bodies goes by body, in the order of the deck") {
    CHECK(trajectory_of(1, false, std::nullopt) == "step,time,x1,vx1,x2,vx2\n3,0.3,1,0.1,11,1.1\n");
    CHECK(trajectory_of(2, false, std::nullopt) ==
          "step,time,x1,y1,vx1,vy1,x2,y2,vx2,vy2\n3,0.3,1,2,0.1,0.2,11,12,1.1,1.2\n");
    CHECK(trajectory_of(3, false, std::nullopt) ==
          "step,time,x1,y1,z1,vx1,vy1,vz1,x2,y2,z2,vx2,vy2,vz2\n3,0.3,1,2,3,0.1,0.2,0.3,11,12,13,1.1,1.2,1.3\n");
}

TEST_CASE("accelerations are forces by masses, and the angle stands last") {
    CHECK(trajectory_of(1, true, std::nullopt) == "step,time,x1,vx1,ax1,x2,vx2,ax2\n3,0.3,1,0.1,2,11,1.1,3.5\n");
    CHECK(trajectory_of(2, true, std::nullopt) ==
          "step,time,x1,y1,vx1,vy1,ax1,ay1,x2,y2,vx2,vy2,ax2,ay2\n"
          "3,0.3,1,2,0.1,0.2,2,3,11,12,1.1,1.2,3.5,4\n");
    CHECK(trajectory_of(1, false, 0.75) == "step,time,x1,vx1,x2,vx2,angle\n3,0.3,1,0.1,11,1.1,0.75\n");
}

TEST_CASE("rows of few bodies are on the disk after a flush, and a file that cannot be made is an error") {
    const test::TemporaryFolder folder;
    FewBodyThermoCsv thermo(folder / "thermo.csv", 1);
    TrajectoryCsv trajectory(folder / "trajectory.csv", {2, 1, false, false});
    thermo.write(0, 0.0, {0.0, 0.5, 0.5, Vec3(1.0, 0.0, 0.0), Vec3::Zero()});
    trajectory.write(swapped_bodies(), std::nullopt);
    thermo.flush();
    trajectory.flush();
    CHECK(test::content_of(folder / "thermo.csv").ends_with("\n0,0,0,0.5,0.5,1\n"));
    CHECK(test::content_of(folder / "trajectory.csv").ends_with("11,1.1\n"));
    CHECK_THROWS_AS(FewBodyThermoCsv(folder / "no" / "thermo.csv", 1), FileError);
    CHECK_THROWS_AS(TrajectoryCsv(folder / "no" / "trajectory.csv", {2, 1, false, false}), FileError);
}
