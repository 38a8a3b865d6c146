#include "ljmd/compare/lammps_output.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string table =
    "LAMMPS (29 Sep 2021)\n"
    "run 0\n"
    "Step PotEng c_kinetic c_virial \n"
    "       0 -1717.2152367680262 404.02209741544175 -5.8431815054052212 \n"
    "WARNING: something or other (src/x.cpp:1)\n"
    "      10 -1.5e3 4.5 1e-300 \n"
    "Loop time of 2.775e-06 on 1 procs for 10 steps with 256 atoms\n\n"
    "1 2 3 4\n";

const std::string frame =
    "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
    "ITEM: ATOMS id xu yu zu \n1 0.25 -1 2e-3\n2 1 2 3\n";

/// What reading all of a log says.
void read_log(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "log") << text;
    LammpsLog log(folder / "log");
    while (log.next_row()) {
    }
    static_cast<void>(log.loop_seconds());
}

void read_frame(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "dump") << text;
    LammpsDump(folder / "dump", 2, "id xu yu zu").next_frame();
}

std::string without(std::string text, const std::string& part, const std::string& instead = "") {
    REQUIRE(text.find(part) != std::string::npos);
    return text.replace(text.find(part), part.size(), instead);
}

}  // namespace

TEST_CASE("a log is read table by table") {
    const TemporaryFolder folder;
    std::ofstream(folder / "log") << table << table;
    LammpsLog log(folder / "log");
    CHECK_THROWS_AS(log.loop_seconds(), DataError);
    for (int turn = 0; turn < 2; ++turn) {
        const auto first = log.next_row();
        REQUIRE(first.has_value());
        CHECK(first->step == 0);
        CHECK(first->potential_energy == -1717.2152367680262);
        CHECK(first->kinetic_energy == 404.02209741544175);
        CHECK(first->virial_pressure == -5.8431815054052212);
        const auto second = log.next_row();
        REQUIRE(second.has_value());
        CHECK(second->step == 10);
        CHECK(second->virial_pressure == 1e-300);
    }
    CHECK_FALSE(log.next_row().has_value());
    CHECK(log.loop_seconds() == 2.775e-06);
}

TEST_CASE("a log that is not as expected is refused, with its line") {
    CHECK_NOTHROW(read_log(table));
    CHECK_THROWS_WITH(read_log(without(table, "-1.5e3", "nan")),
                      Contains("log:6: the potential energy must be a finite"));
    CHECK_THROWS_WITH(read_log(without(table, " 4.5")), Contains("log:6: a row of 4 numbers was expected"));
    CHECK_THROWS_WITH(read_log(table.substr(0, table.find("Loop"))), Contains("ends within a table"));
    CHECK_THROWS_WITH(read_log("LAMMPS\n"), Contains("no line tells the time of the loop"));
    CHECK_THROWS_WITH(read_log(without(table, "2.775e-06", "soon")), Contains("the time of the loop must be"));
}

TEST_CASE("a dump is read frame by frame") {
    const TemporaryFolder folder;
    std::ofstream(folder / "dump") << frame << without(frame, "\n7\n", "\n9\n");
    LammpsDump dump(folder / "dump", 2, "id xu yu zu");
    dump.next_frame();
    CHECK(dump.step() == 7);
    CHECK(dump.vectors() == std::vector<Vec3>{Vec3(0.25, -1.0, 2e-3), Vec3(1.0, 2.0, 3.0)});
    dump.next_frame();
    CHECK(dump.step() == 9);
    CHECK(dump.vectors().size() == 2);
    CHECK_THROWS_WITH(dump.next_frame(), Contains("the dump ends before all its frames"));
}

TEST_CASE("a dump that is not as expected is refused, with its line") {
    CHECK_NOTHROW(read_frame(frame));
    CHECK_THROWS_WITH(read_frame(without(frame, "\n2\nITEM", "\n3\nITEM")), Contains("dump:4: 2 atoms were expected"));
    CHECK_THROWS_WITH(read_frame(without(frame, "id xu", "xu")), Contains("dump:9: 'ITEM: ATOMS id xu yu zu' was"));
    CHECK_THROWS_WITH(read_frame(without(frame, "pp pp pp", "ff pp pp")), Contains("dump:5: "));
    CHECK_THROWS_WITH(read_frame(without(frame, "1 0.25", "2 0.25")), Contains("dump:10: atom 1 and its xu yu zu"));
    CHECK_THROWS_WITH(read_frame(without(frame, "0.25", "inf")), Contains("dump:10: ") && Contains("finite"));
    CHECK_THROWS_WITH(read_frame(without(frame, "2 1 2 3\n")), Contains("the dump ends"));
    CHECK_THROWS_WITH(read_frame(without(frame, "-1 ")), Contains("dump:10: atom 1"));
}

TEST_CASE("LAMMPS is known by its help") {
    const std::string help =
        "\nLarge-scale Atomic/Molecular Massively Parallel Simulator - 29 Sep 2021 - Update 2\n\nUsage\n\n"
        "Installed packages:\n\nKSPACE MOLECULE \nOPT RIGID \n\nList of OPENMP\n";
    const auto version = lammps_version(help);
    REQUIRE(version.has_value());
    CHECK(version->version == "29 Sep 2021 - Update 2");
    CHECK_FALSE(version->openmp);
    CHECK(lammps_version(without(help, "OPT", "OPENMP"))->openmp);
    CHECK(lammps_version(without(help, "OPT", "USER-OMP"))->openmp);
    CHECK_FALSE(lammps_version(without(help, "Installed packages:\n\n"))->openmp);
    CHECK_FALSE(lammps_version("GNU bash, version 5").has_value());
}
