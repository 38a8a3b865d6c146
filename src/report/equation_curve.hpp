#pragma once

#include <string>
#include <vector>

#include "report/page_content.hpp"

namespace ljmd {

/// A point of a sweep on the way of a curve: its place on the axis, its state, and the equation of state of its fluid.
struct StateOnAxis {
    double place;
    double temperature;
    double temperature_error;  ///< NaN if it is not known
    double density;
    std::string equation;  ///< empty: there is none
    std::string series;    ///< the curve that it belongs to
};

/// What equations of state say between the points of a sweep: a table with the axis' column, `series`, and a column
/// NAME_reference for each observable that equations have. Between neighbouring points of a series, temperature and
/// density are linear in the place; temperatures that agree within three errors, as along an isotherm, are their mean,
/// so that the curve does not follow their noise, where the axis is not the temperature. Where no one phase is stable,
/// or the equation was not fitted, there is no value.
/// @param x       name of the axis' column
/// @param states  sorted by place within each series
/// @return without rows where no series has two points with one equation
[[nodiscard]] PageTable equation_curves(const std::string& x, const std::vector<StateOnAxis>& states);

}  // namespace ljmd
