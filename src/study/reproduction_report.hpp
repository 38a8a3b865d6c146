#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "study/reproduction.hpp"

namespace ljmd {

/// The table of `ljmd reproduce verlet1967`. Text, on the screen: one line per row, then chi-square and remarks. Data,
/// in results.json: rows and chi-square.
/// @param screen  columns of the terminal that the text has to fit: columns stand closer, then the columns of the
/// cutoff are left out. None: the whole table
[[nodiscard]] Document reproduction_report(const std::vector<ReproducedRow>& rows,
                                           std::optional<std::size_t> screen = std::nullopt);

/// rows.csv: rho, T (Verlet's), T_measured, Z and U at T with standard errors, the cutoff corrections, values of
/// Verlet, of Thol 2016 and of Kolafa and Nezbeda, z-scores, steps, soundness, remark.
[[nodiscard]] std::string reproduction_csv(const std::vector<ReproducedRow>& rows);

/// rows.md: the table in Markdown.
[[nodiscard]] std::string reproduction_markdown(const std::vector<ReproducedRow>& rows);

/// isotherms.csv, for the picture: T, rho and Z of both equations of state along isotherms near the rows, from density
/// 0.9 down to 0.3 or to where Thol's fluid is unstable.
[[nodiscard]] std::string isotherms_csv();

/// The remark on a row: a known remark on the printed values, else whether they differ from the simulation by more than
/// chance while Thol's equation agrees with it.
[[nodiscard]] std::string remark_of(const ReproducedRow& row);

}  // namespace ljmd
