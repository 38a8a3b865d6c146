#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/core/data.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

/// The member `tracks` of the page's data, from trajectory.csv: at most `most` frames at even distances, positions as
/// float32, and the relative error of the energy at each frame. src/report/web/README.md has its members.
/// @param thermo  the history; the energy at a frame is taken from the last row before or at it
/// @param masses  of the bodies; may be empty
/// @throws DataError  a column is missing
[[nodiscard]] Data body_tracks(const DataTable& trajectory, const DataTable& thermo, const std::vector<double>& masses,
                               std::size_t most = 3000);

/// The number of bodies and dimensions that the columns of trajectory.csv are for.
struct TrackShape {
    std::size_t bodies;
    std::size_t dimensions;
};
[[nodiscard]] TrackShape track_shape(const DataTable& trajectory);

/// (E - E_0)/|E_0| of each row, or E - E_0 where E_0 = 0. @throws DataError
[[nodiscard]] std::vector<double> energy_errors(const DataTable& thermo);

}  // namespace ljmd
