#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/few_body/few_body.hpp"

namespace ljmd {

/// Columns of the history of a few-body run, one row per sample, in a file (FewBodyThermoCsv) or in memory: step, time,
/// potential_energy, kinetic_energy, total_energy, momentum_x (momentum_y, momentum_z in two and three dimensions),
/// then angular_momentum_z in two dimensions, all three components in three.
class FewBodyThermoColumns {
  public:
    explicit FewBodyThermoColumns(int dimensions) : dimensions_(dimensions) {}

    [[nodiscard]] std::vector<std::string> names() const;

    /// @return one number a column
    [[nodiscard]] std::vector<double> row(Index step, double time, const FewBodyTotals& totals) const;

  private:
    int dimensions_;
};

/// Columns of the trajectories of a few bodies, one row per time, in a file (TrajectoryCsv) or in memory: step, time,
/// then for each body its position (x1, y1, z1), velocity (vx1, ...) and, if asked for, acceleration (ax1, ...), with
/// as many components as there are dimensions; last, if the force has one, the polar angle that belongs to the
/// coordinate.
class TrajectoryColumns {
  public:
    TrajectoryColumns(Index bodies, int dimensions, bool accelerations, bool angle)
        : bodies_(bodies), dimensions_(dimensions), accelerations_(accelerations), angle_(angle) {}

    [[nodiscard]] std::vector<std::string> names() const;

    /// @pre forces are current if there are accelerations; an angle is given if there is a column for it
    /// @return one number a column
    [[nodiscard]] std::vector<double> row(const State& state, std::optional<double> angle) const;

  private:
    Index bodies_;
    int dimensions_;
    bool accelerations_;
    bool angle_;
};

}  // namespace ljmd
