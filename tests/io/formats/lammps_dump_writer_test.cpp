#include "io/formats/lammps_dump_writer.hpp"

#include "catch.hpp"

#include "io/formats/lammps_dump.hpp"
#include "io/output_fixtures.hpp"
#include "io/three_atoms.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a dump reads back as the state that it was written from, to the last bit") {
    const TemporaryFolder folder;
    State state = three_atoms();
    state.wrap();
    state.write_forces().setRandom();
    state.mark_forces_current();
    const std::vector<double> energies{-1.0 / 3.0, 0.1, -6.1};
    {
        OutputFile file(folder / "a.lammpsdump");
        write_lammps_dump_frame(file, state, {.velocities = true, .forces = true, .energies = energies});
        ++state.step;
        write_lammps_dump_frame(file, state, {});
        file.close();
    }
    LammpsDump dump(folder / "a.lammpsdump");
    REQUIRE(dump.next_frame());
    CHECK(dump.step() + 1 == state.step);
    CHECK(dump.edges() == state.box().edges());
    const auto rows =
        dump.read_atoms({"id", "x", "y", "z", "ix", "iy", "iz", "vx", "vy", "vz", "fx", "fy", "fz", "c_pe"});
    const std::vector<Index> index_of = state.index_of();
    REQUIRE(rows.rows() == 3);
    for (Index id = 0; id < 3; ++id) {
        const Index i = index_of[static_cast<std::size_t>(id)];
        const Eigen::VectorXd row = rows.row(id);
        CHECK(row[0] == static_cast<double>(id + 1));
        CHECK(row.segment<3>(1) == state.positions().col(i));
        CHECK(row.segment<3>(4) == state.image(i).cast<double>());
        CHECK(row.segment<3>(7) == state.velocities().col(i));
        CHECK(row.segment<3>(10) == state.forces().col(i));
        CHECK(row[13] == energies[static_cast<std::size_t>(id)]);
    }
    REQUIRE(dump.next_frame());
    CHECK_FALSE(dump.has("fx"));
    CHECK_FALSE(dump.has("vx"));
    CHECK_FALSE(dump.has("c_pe"));
    CHECK_THAT(content_of(folder / "a.lammpsdump"), !Contains("ITEM: TIME\n"));
}

TEST_CASE("the dump of a copy tells no more than its source") {
    const TemporaryFolder folder;
    State state = three_atoms();
    state.wrap();
    OutputFile file(folder / "a.lammpsdump");
    write_lammps_dump_frame(file, state, {.source = FrameFacts{.step = 40, .ids = {3, 7, 9}}});
    CHECK_THROWS_AS(write_lammps_dump_frame(file, state, {.source = FrameFacts{}}), ContractViolation);
    file.close();
    LammpsDump dump(folder / "a.lammpsdump");
    REQUIRE(dump.next_frame());
    CHECK(dump.step() == 40);
    CHECK_FALSE(dump.has("ix"));
    const auto rows = dump.read_atoms({"id", "x", "y", "z"});
    CHECK(rows(2, 0) == 9.0);
    CHECK(Vec3(rows.row(2).tail<3>()) == state.unwrapped(state.index_of()[2]));
}
