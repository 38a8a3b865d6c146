#include "compare/lammps_output.hpp"

#include <fstream>
#include "catch.hpp"

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

/// What reading all of a log says.
void read_log(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "log") << text;
    LammpsLog log(folder / "log");
    while (log.next_row()) {
    }
    static_cast<void>(log.loop_seconds());
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
