#include "io/tables/few_body_columns.hpp"

#include "catch.hpp"

using namespace ljmd;

TEST_CASE("the history of few bodies has a number in each of its columns") {
    const FewBodyTotals totals{-1.0, 2.0, 1.0, Vec3(1.5, 2.5, 3.5), Vec3(4.5, 5.5, 6.5)};
    const auto row = [&](int dimensions) { return FewBodyThermoColumns(dimensions).row(7, 0.25, totals); };
    CHECK(row(1) == std::vector{7.0, 0.25, -1.0, 2.0, 1.0, 1.5});
    CHECK(row(2) == std::vector{7.0, 0.25, -1.0, 2.0, 1.0, 1.5, 2.5, 6.5});
    CHECK(row(3) == std::vector{7.0, 0.25, -1.0, 2.0, 1.0, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5});
    for (const int dimensions : {1, 2, 3}) {
        CHECK(FewBodyThermoColumns(dimensions).names().size() == row(dimensions).size());
    }
}

TEST_CASE("trajectories of few bodies have a number in each of their columns, accelerations and an angle among them") {
    State body(1);
    body.step = 3;
    body.time = 0.5;
    body.write_positions().col(0) = Vec3(1.0, 2.0, 3.0);
    body.write_velocities().col(0) = Vec3(4.0, 5.0, 6.0);
    body.write_forces().col(0) = Vec3(14.0, 16.0, 18.0);
    body.write_masses()[0] = 2.0;
    CHECK(TrajectoryColumns(1, 2, false, false).row(body, std::nullopt) == std::vector{3.0, 0.5, 1.0, 2.0, 4.0, 5.0});
    CHECK(TrajectoryColumns(1, 2, true, false).row(body, std::nullopt) ==
          std::vector{3.0, 0.5, 1.0, 2.0, 4.0, 5.0, 7.0, 8.0});
    CHECK(TrajectoryColumns(1, 1, true, true).row(body, 0.75) == std::vector{3.0, 0.5, 1.0, 4.0, 7.0, 0.75});
    CHECK(TrajectoryColumns(1, 1, true, true).names() ==
          std::vector<std::string>{"step", "time", "x1", "vx1", "ax1", "angle"});
}
