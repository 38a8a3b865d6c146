#include "judge/row_judgement.hpp"

#include <cmath>
#include "catch.hpp"

#include "judge/failed_checks.hpp"
#include "judge/own_run.hpp"
#include "judge/point_judgement.hpp"
#include "judge/small_problem.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"

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
                           .digits = 1e-9,
                           .tail_energy = -50.0});
    }
    [[nodiscard]] double volume() const { return problem_.fluid.edges.prod(); }

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
    REQUIRE(test::failed_checks(judged).size() == 1);
    CHECK_THAT(test::failed_checks(judged)[0], StartsWith("thermo.csv, steps 5 to 40: potential energy, worst at "));
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
    CHECK_THAT(rows.judged(table).others.at(0),
               StartsWith("constant: the potential energy of thermo.csv has 3 added") &&
                   Catch::Contains("that would be -47 instead of -50: check its formula"));
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

TEST_CASE("a pressure of rho T is no mistake if each row has its own T, and one of a constant T is") {
    const Rows rows;
    const double thrice_volume = 3.0 * rows.volume();
    ThermoAnswer table = rows.table();
    ThermoAnswer constant = rows.table();
    for (std::size_t k = 0; k < table.steps.size(); ++k) {
        const double motion = 2.0 * table.kinetic_energy[k] / thrice_volume;
        table.pressure[k] += motion * (108.0 / 107.0 - 1.0);
        constant.pressure[k] += 0.7 - motion;
    }
    CHECK_THAT(rows.judged(table).mistakes.at(0),
               StartsWith("3N against 3N-3") && Catch::Contains("no mistake in itself"));
    CHECK_FALSE(rows.judged(table).has_constant_motion);
    CHECK_THAT(rows.judged(constant).mistakes.at(0),
               StartsWith("constant temperature") && Catch::Contains("the kinetic part 0.7 in all rows"));
    CHECK(rows.judged(constant).has_constant_motion);
}

TEST_CASE("numbers of rows in the place of steps are found out") {
    const Rows rows;
    ThermoAnswer table = rows.table();
    for (Index& step : table.steps) {
        step /= 5;
    }
    const RowJudgement judged = rows.judged(table);
    CHECK(judged.checks.size() == 4);
    REQUIRE(judged.mistakes.size() == 1);
    CHECK_THAT(judged.mistakes[0], StartsWith("row numbers: ") && Catch::Contains("those of the steps 5, 10, ..."));
    CHECK(last_compared_step(table, 5, 500) == 40);
    CHECK(last_compared_step(table, 5, 30) == 30);
    CHECK(last_compared_step(rows.table(), 5, 30) == 30);
    table.kinetic_energy[2] += 1.0;
    CHECK(rows.judged(table).mistakes.empty());
}

TEST_CASE("a table's temperature of other degrees of freedom is named") {
    const Rows rows;
    ThermoAnswer table = rows.table();
    const auto with = [&](double freedom) {
        table.temperature.clear();
        for (const double k : table.kinetic_energy) {
            table.temperature.push_back(2.0 * k / freedom);
        }
        const RowJudgement judged = judge_temperatures(table, 108, 321, 1e-9);
        return judged.mistakes.empty() ? test::failed_checks(judged).size() == 1 ? "failed" : "" : judged.mistakes[0];
    };
    CHECK(with(321.0).empty());
    CHECK_THAT(with(324.0), StartsWith("3N against 3N-3"));
    CHECK_THAT(with(318.0), StartsWith("3N-6 against 3N-3"));
    CHECK(with(300.0) == "failed");
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
