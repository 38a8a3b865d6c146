#pragma once

#include <string>
#include <vector>

#include "ljmd/study/reproduction.hpp"

namespace ljmd {

// The table of `ljmd reproduce verlet1967`, in four forms.

/// For people, as it ends on the screen: a line a row, then chi-square and remarks.
[[nodiscard]] std::string reproduction_table(const std::vector<ReproducedRow>& rows);

/// rows.csv: rho, T (Verlet's), T_measured, Z, U at T with standard errors, what the cutoff misses, Verlet's values,
/// those of Thol 2016 and of Kolafa and Nezbeda, z-scores, steps, soundness, remark.
[[nodiscard]] std::string reproduction_csv(const std::vector<ReproducedRow>& rows);

/// rows.md: the table in Markdown.
[[nodiscard]] std::string reproduction_markdown(const std::vector<ReproducedRow>& rows);

/// results.json: rows and chi-square.
[[nodiscard]] std::string reproduction_json(const std::vector<ReproducedRow>& rows);

/// isotherms.csv: T, rho and Z of both equations of state along the isotherms near which the rows lie, from density 0.9
/// down to 0.3 or to where Thol's fluid is unstable; for the picture.
[[nodiscard]] std::string isotherms_csv();

/// What is to be said of a row: what is known of the printed values, and whether they differ from what was found by
/// more than can be chance while Thol's equation agrees with it.
[[nodiscard]] std::string remark_of(const ReproducedRow& row);

}  // namespace ljmd
