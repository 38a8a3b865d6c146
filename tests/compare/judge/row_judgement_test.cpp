#include "ljmd/compare/judge/row_judgement.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "compare/judge/failed_checks.hpp"
#include "compare/judge/small_problem.hpp"
#include "ljmd/compare/judge/own_run.hpp"
#include "ljmd/compare/judge/point_judgement.hpp"
#include "ljmd/potentials/tail_correction.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::StartsWith;

namespace {

/// Rows of the small problem at steps 5, 10, ... 40, as ljmd has them.
class Rows {
  public:
    Rows()
        : problem_(small_problem()),
          ours_(own_rows(problem_.fluid, TailCorrection(), *MadePeer::force_field_of(problem_.fluid), {},
                         problem_.stage.time_step, 41)) {}

    [[nodiscard]] const OwnRow& at(Index step) const { return ours_[static_cast<std::size_t>(step)]; }

    /// A table that has the rows of other steps.
    [[nodiscard]] ThermoAnswer table(Index shift = 0) const {
        ThermoAnswer made;
        for (Index step = 5; step <= 40; step += 5) {
            const OwnRow& row = at(step + shift);
            made.steps.push_back(step);
            made.potential_energy.push_back(row.potential_energy);
            made.kinetic_energy.push_back(row.kinetic_energy);
            made.pressure.push_back(row.pressure);
            made.volume.push_back(problem_.fluid.edges.prod());
        }
        return made;
    }

    [[nodiscard]] RowJudgement judged(const ThermoAnswer& table) const {
        const Agreement agreement = engine_agreement(situation_of(problem_.fluid, problem_.stage.time_step));
        return judge_rows(table, ours_,
                          {.atoms = 108,
                           .volume = problem_.fluid.edges.prod(),
                           .thermo_every = 5,
                           .agreement = agreement,
                           .digits = 1e-9});
    }

  private:
    Problem problem_;
    std::vector<OwnRow> ours_;
};

}  // namespace

TEST_CASE("rows of the same trajectory pass, and need not be all there") {
    const Rows rows;
    const RowJudgement all = rows.judged(rows.table());
    CHECK(test::failed_checks(all).empty());
    CHECK(all.checks.size() == 4);
    CHECK(all.mistakes.empty());
    ThermoAnswer few = rows.table();
    few.pressure.clear();
    few.volume.clear();
    CHECK(rows.judged(few).checks.size() == 2);
}

TEST_CASE("an energy that is written one step late fails, and is named") {
    const Rows rows;
    ThermoAnswer table = rows.table();
    table.potential_energy = rows.table(-1).potential_energy;
    const RowJudgement judged = rows.judged(table);
    CHECK(test::failed_checks(judged) == std::vector<std::string>{"thermo.csv, steps 5 to 40: potential energy"});
    CHECK(judged.mistakes ==
          std::vector<std::string>{"one step late: the potential energy of thermo.csv is that of 1 step "
                                   "earlier than the row says"});
    table = rows.table();
    table.pressure = rows.table(1).pressure;
    CHECK_THAT(rows.judged(table).mistakes.at(0), StartsWith("one step early: the pressure"));
}

TEST_CASE("kinetic energies of half-step velocities are named, and their means") {
    const Rows rows;
    for (const int way : {0, 1, 2}) {
        ThermoAnswer table = rows.table();
        for (std::size_t k = 0; k < table.steps.size(); ++k) {
            const OwnRow& row = rows.at(table.steps[k]);
            table.kinetic_energy[k] = way == 0   ? row.kinetic_energy_before
                                      : way == 1 ? row.kinetic_energy_after
                                                 : 0.5 * (row.kinetic_energy_before + row.kinetic_energy_after);
        }
        const RowJudgement judged = rows.judged(table);
        REQUIRE(judged.mistakes.size() == 1);
        CHECK_THAT(judged.mistakes[0], StartsWith("half-step velocities: the kinetic energy of thermo.csv is ") &&
                                           Catch::Contains(way == 0   ? "half a time step earlier"
                                                           : way == 1 ? "half a time step later"
                                                                      : "as leapfrog gives it"));
    }
}

TEST_CASE("half-step kinetic energies of our rows are those of the velocities there") {
    const Problem problem = small_problem();
    const auto field = MadePeer::force_field_of(problem.fluid);
    const auto rows = own_rows(problem.fluid, TailCorrection(), *field, {}, problem.stage.time_step, 1);
    JudgedTrajectory start{
        problem.fluid.edges, problem.stage.time_step, {{.step = 0, .positions = problem.fluid.positions}}};
    follow(problem.fluid, *field, {}, start);
    CHECK(rows[0].kinetic_energy == Approx(kinetic_energy(problem.fluid)).epsilon(1e-14));
    for (const auto& [value, side] :
         {std::pair(rows[0].kinetic_energy_before, -0.5), std::pair(rows[0].kinetic_energy_after, 0.5)}) {
        CHECK(value == Approx(half_step_kinetic_energy(problem.fluid, start.frames[0].our_forces,
                                                       side * problem.stage.time_step))
                           .epsilon(1e-13));
    }
}

TEST_CASE("a constant or a factor of all rows is no mistake of rows, and is told apart") {
    const Rows rows;
    ThermoAnswer table = rows.table();
    for (double& u : table.potential_energy) {
        u += 3.0;
    }
    CHECK(rows.judged(table).mistakes.empty());
    CHECK_THAT(rows.judged(table).others.at(0), StartsWith("constant: the potential energy of thermo.csv has 3 added"));
    table = rows.table();
    for (double& k : table.kinetic_energy) {
        k *= 2.0;
    }
    CHECK_THAT(rows.judged(table).others.at(0), StartsWith("factor: the kinetic energy of thermo.csv is 2 times"));
    // both at once are met nearly by either, and are neither
    table = rows.table();
    for (double& u : table.potential_energy) {
        u = 2.0 * u + 50.0;
    }
    CHECK_FALSE(test::failed_checks(rows.judged(table)).empty());
    CHECK(rows.judged(table).others.empty());
}

TEST_CASE("a table of few digits is named by how many it has") {
    const Rows rows;
    ThermoAnswer table = rows.table();
    for (double& u : table.potential_energy) {
        u = std::round(u * 1e4) / 1e4;
    }
    CHECK(rows.judged(table).mistakes ==
          std::vector<std::string>{"few digits: the potential energy of thermo.csv has 4 decimals"});
}
