#include "compare/lammps_input.hpp"

#include <fstream>
#include "catch.hpp"

#include "compare/small_fluid.hpp"
#include "forces/every_potential.hpp"
#include "io/formats/configuration_reader.hpp"
#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a data file lists box, masses, atoms and velocities") {
    Fluid fluid = small_fluid();
    fluid.positions = {Vec3(0.5, 1.0, 2.25), Vec3(0.1, 3.0, 4.0), Vec3(1e-20, 0.0, 5.0)};
    fluid.velocities = {Vec3(1.5, -2.0, 0.0), Vec3(0.0, 0.3, 0.0), Vec3(0.0, 0.0, 0.75)};
    fluid.masses = {2.0, 1.0, 2.0};
    CHECK(lammps_data(fluid) ==
          "LAMMPS data file by ljmd, units = lj\n\n"
          "3 atoms\n2 atom types\n\n"
          "0.0 6 xlo xhi\n0.0 7 ylo yhi\n0.0 8 zlo zhi\n\n"
          "Masses\n\n1 2\n2 1\n\n"
          "Atoms # atomic\n\n"
          "1 1 0.5 1 2.25\n2 2 0.1 3 4\n3 1 1e-20 0 5\n\n"
          "Velocities\n\n"
          "1 1.5 -2 0\n2 0 0.3 0\n3 0 0 0.75\n");
}

TEST_CASE("a data file reads back to the last bit") {
    const TemporaryFolder folder;
    const Fluid fluid = small_fluid();
    std::ofstream(folder / "start.data") << lammps_data(fluid);
    const Configuration configuration = read_configuration(folder / "start.data", std::nullopt);
    CHECK(configuration.edges == fluid.edges);
    CHECK(configuration.positions == fluid.positions);
    CHECK(configuration.velocities == fluid.velocities);
    CHECK(configuration.masses == fluid.masses);
}

TEST_CASE("each potential has its pair style") {
    const std::map<std::string, double> numbers{{"well_depth", 1.5}, {"steepness", 5.0}, {"minimum", 1.25}};
    const auto style = [&](const std::string& formula, const std::string& truncation) {
        const bool is_morse = formula == "morse";
        return lammps_pair_style(
            made_potential(formula, truncation, {2.5, 2.0}, is_morse ? numbers : std::map<std::string, double>{}));
    };
    const std::string units = "pair_coeff * * 1.0 1.0\n";
    CHECK(style("lennard-jones", "cut") == "pair_style lj/cut 2.5\n" + units + "pair_modify shift no tail no\n");
    CHECK(style("lennard-jones", "shifted") == "pair_style lj/cut 2.5\n" + units + "pair_modify shift yes tail no\n");
    CHECK(style("lennard-jones", "force-shifted") == "pair_style lj/smooth/linear 2.5\n" + units);
    CHECK(style("lennard-jones", "switched") == "pair_style lj/mdf 2 2.5\n" + units);
    const std::string morse = "pair_coeff * * 1.5 5 1.25\n";
    CHECK(style("morse", "cut") == "pair_style morse 2.5\n" + morse + "pair_modify shift no\n");
    CHECK(style("morse", "shifted") == "pair_style morse 2.5\n" + morse + "pair_modify shift yes\n");
    CHECK(style("morse", "force-shifted") == "pair_style morse/smooth/linear 2.5\n" + morse);
}

TEST_CASE("a potential that LAMMPS does not have is refused in every script") {
    const Fluid fluid = small_fluid("morse", "switched");
    const std::string message =
        "LAMMPS has no potential 'morse' with truncation 'switched'; it has: lennard-jones cut, lennard-jones shifted, "
        "lennard-jones force-shifted, lennard-jones switched, morse cut, morse shifted, morse force-shifted";
    CHECK_THROWS_AS(static_cast<void>(lammps_pair_style(fluid.potential)), InputError);
    CHECK_THROWS_WITH(static_cast<void>(lammps_pair_style(fluid.potential)), message);
    CHECK_THROWS_WITH(static_cast<void>(lammps_point_input(fluid)), message);
    CHECK_THROWS_WITH(static_cast<void>(lammps_follow_input(fluid, 0.004, {0})), message);
    CHECK_THROWS_WITH(static_cast<void>(lammps_sample_input(fluid, 0.004, 1, 1, 0)), message);
    CHECK_THROWS_WITH(static_cast<void>(lammps_user_input(fluid, 0.004, 1, "")), message);
}

namespace {

bool is_in_lammps(const PairPotential& potential) {
    try {
        static_cast<void>(lammps_pair_style(potential));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

TEST_CASE("LAMMPS has tail corrections for plain Lennard-Jones alone") {
    for (const PairPotential& potential : every_potential()) {
        const std::string name = potential.formula() + " " + potential.truncation();
        INFO(name);
        if (is_in_lammps(potential)) {
            CHECK(lammps_has_tail(potential) == (name == "lennard-jones cut"));
        } else {
            CHECK(potential.formula() != "lennard-jones");  // LAMMPS has them all
        }
    }
    CHECK_THAT(lammps_point_input(small_fluid("lennard-jones", "cut", true)),
               Contains("run 0\n") && Catch::EndsWith("pair_modify tail yes\nrun 0\n"));
    CHECK_THAT(lammps_point_input(small_fluid("lennard-jones", "switched", true)), !Contains("tail"));
    const std::string with = lammps_user_input(small_fluid("lennard-jones", "cut", true), 0.004, 1, "");
    CHECK_THAT(with, Contains("tail no\n") && Contains("\npair_modify tail yes\n"));
    CHECK_THAT(lammps_user_input(small_fluid("lennard-jones", "switched", true), 0.004, 1, ""),
               !Contains("pair_modify") && Contains("# Tail corrections are wanted"));
    CHECK_THAT(lammps_user_input(small_fluid(), 0.004, 1, ""), !Contains("tail yes") && !Contains("# Tail"));
}

TEST_CASE("a script that follows steps has a piece of a run for each") {
    const std::string text = lammps_follow_input(small_fluid(), 0.004, {0, 1, 10});
    const std::string frame =
        "write_dump all custom frames.dump id xu yu zu modify sort id format float %.17g append yes\n";
    CHECK_THAT(text, Contains("neigh_modify every 1 delay 0 check yes\n"));
    CHECK_THAT(text, Catch::EndsWith("timestep 0.004\nthermo 0\nrun 0 post no\n" + frame + "run 1 pre no post no\n" +
                                     frame + "run 9 pre no post no\n" + frame));
    CHECK_THAT(lammps_follow_input(small_fluid(), 0.1 + 0.2, {0}), Contains("timestep 0.30000000000000004\n"));
}

TEST_CASE("a script that samples has rows and frames as often as wanted") {
    CHECK_THAT(lammps_sample_input(small_fluid(), 0.004, 200, 10, 50),
               Catch::EndsWith("thermo 10\n"
                               "dump frames all custom 50 frames.dump id xu yu zu\n"
                               "dump_modify frames sort id format float %.17g\n"
                               "run 200\n"));
    CHECK_THAT(lammps_sample_input(small_fluid(), 0.004, 200, 0, 0),
               Catch::EndsWith("thermo 0\nrun 200\n") && !Contains("dump"));
}

TEST_CASE("a title cannot be a command") {
    const std::string text = lammps_user_input(small_fluid(), 0.004, 7, "T = 1 \"\"\" $x\nshell ls &");
    CHECK_THAT(text, Catch::StartsWith("# T = 1 ___ _x_shell ls _\n# Made by ljmd"));
    CHECK_THAT(text, Contains("variable steps index 7\n"));
}
