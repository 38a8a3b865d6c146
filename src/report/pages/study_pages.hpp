#pragma once

#include <filesystem>

#include "report/page_content.hpp"

namespace ljmd {

/// The page of a sweep: its observables against the varied keys, beside an equation of state where there is one of the
/// fluid, from those points that are finished. @throws DataError  its sweep.json is damaged
[[nodiscard]] PageContent sweep_page(const std::filesystem::path& directory);

/// The page of replicas of one deck: their merged results, and each replica beside them.
/// @throws DataError  its sweep.json is damaged
[[nodiscard]] PageContent replicas_page(const std::filesystem::path& directory);

/// The page of reference values: value, errors and equation of state of each property, g(r) if it was asked for.
[[nodiscard]] PageContent reference_page(const std::filesystem::path& directory);

/// The page of a reproduced table: z-scores, isotherms, the rows, from those rows that are finished.
[[nodiscard]] PageContent reproduction_page(const std::filesystem::path& directory);

/// The page of a comparison that `ljmd compare --out` has written, with OpenMM, LAMMPS, GSL or an engine of the user.
/// @throws DataError  it has no comparison_results(), or they are damaged
[[nodiscard]] PageContent comparison_page(const std::filesystem::path& directory);

/// The member `points` of the page's data: the runs of a study, with links relative to its directory.
/// @param runs  as study_report() gives them
[[nodiscard]] Data study_points(const Data& runs, const std::filesystem::path& directory);

/// State of a study and words about its runs, for the head of its page.
void add_study_state(PageContent& page, const Data& study);

}  // namespace ljmd
